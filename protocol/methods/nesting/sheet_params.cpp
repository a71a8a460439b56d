#include "protocol/methods/nesting/sheet_params.h"

#include <algorithm>
#include <utility>

#include "core/geometry/polygon.h"
#include "protocol/formats/jagua/bins.h"

namespace selvage::protocol::schema {

using methods::nesting::SheetOutline;

Json Wire<SheetOutline>::write(const SheetOutline& value) {
  Json corners = Json::array();
  for (const calls::Point& corner : value.corners) corners.push_back(Wire<calls::Point>::write(corner));
  return corners;
}

void Wire<SheetOutline>::read(const FieldAt& at, SheetOutline& value) {
  value.corners = formats::read_points(at.fields.array(at.key), at.pointer(), at.mistake);
}

SheetOutline Wire<SheetOutline>::read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
  if (value.is_array()) return {formats::read_points(value, at, mistake)};
  mistake.add(ErrorCode::kWrongType, "is not a list; a list of corners [x, y] is allowed", at);
  return {};
}

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::nesting {
namespace {

using formats::jagua::Bin;
using selvage::nesting::sheets::Sheet;
using selvage::nesting::sheets::SheetZone;

using Corners = std::vector<calls::Point>;

// The low corner of the bounding box, from which positions on a sheet are measured.  Only the size of a sheet is
// limited by the lattice, not how far from the origin it was drawn.
calls::Point low_corner(const Corners& corners) {
  if (corners.empty()) return {};
  calls::Point low = corners.front();
  for (const calls::Point& corner : corners) low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
  return low;
}

// A polygon of a sheet that begins at `origin`.
Result<Polygon> polygon_of(const Corners& given, calls::Point origin, Resolution resolution, const std::string& field) {
  Polygon corners;
  for (const calls::Point& corner : given) {
    const calls::Point moved{corner.x - origin.x, corner.y - origin.y};
    const std::string at_corner = field + "/" + std::to_string(corners.size());
    const auto at = calls::place_on_lattice(moved, resolution, at_corner);
    if (!at) {
      return Error{at.error().code, "measured from the sheet's lower left corner, " + at.error().message, at_corner};
    }
    corners.push_back(*at);
  }
  auto clean = geometry::clean_polygon(corners);
  if (clean) return std::move(clean->polygon);
  if (clean.error().code == ErrorCode::kTooManyVertices) return Error{clean.error().code, clean.error().message, field};
  return Error{ErrorCode::kOutOfRange, "is not a simple polygon: " + clean.error().message, field};
}

Result<Sheet> rectangle_of(const SheetParams& params, Resolution resolution, const std::string& field) {
  if (!params.width || !params.length) {
    return Error{ErrorCode::kMissingField, "is missing; a sheet has a width and a length, or an outline",
                 field + (params.width ? "/length" : "/width")};
  }
  const auto corner = calls::place_on_lattice({*params.length, *params.width}, resolution, field);
  if (!corner) return corner.error();
  // Both are rounded down.
  return Sheet{.width = formats::overlap_on_lattice(*params.width, resolution),
               .length = formats::overlap_on_lattice(*params.length, resolution)};
}

Result<std::vector<SheetZone>> zones_of(const SheetParams& params, calls::Point origin, Resolution resolution,
                                        const std::string& field) {
  std::vector<SheetZone> zones;
  for (std::size_t k = 0; params.holes && k < params.holes->size(); ++k) {
    auto hole = polygon_of((*params.holes)[k].corners, origin, resolution, field + "/holes/" + std::to_string(k));
    if (!hole) return hole.error();
    zones.push_back({*std::move(hole)});
  }
  for (std::size_t k = 0; params.zones && k < params.zones->size(); ++k) {
    const SheetZoneParams& given = (*params.zones)[k];
    auto zone =
        polygon_of(given.outline.corners, origin, resolution, field + "/zones/" + std::to_string(k) + "/outline");
    if (!zone) return zone.error();
    zones.push_back({*std::move(zone), given.quality});
  }
  return zones;
}

Result<Sheet> sheet_of(const SheetParams& params, Resolution resolution, const std::string& field) {
  const calls::Point origin = params.outline ? low_corner(params.outline->corners) : calls::Point{};
  auto zones = zones_of(params, origin, resolution, field);
  if (!zones) return zones.error();
  Result<Sheet> sheet = Sheet{};
  if (!params.outline) {
    sheet = rectangle_of(params, resolution, field);
    if (!sheet) return sheet;
    sheet->zones = *std::move(zones);
  } else if (params.width || params.length) {
    return Error{ErrorCode::kOutOfRange,
                 "is given together with a width or a length; a sheet has either an outline or both of these",
                 field + "/outline"};
  } else {
    const auto outline = polygon_of(params.outline->corners, origin, resolution, field + "/outline");
    if (!outline) return outline.error();
    sheet = selvage::nesting::sheets::sheet_within(*outline, *std::move(zones));
  }
  sheet->count = params.count;
  sheet->cost = params.cost;
  return sheet;
}

Corners corners_of(const formats::jagua::BinPolygon& given) {
  Corners corners;
  for (const document::Spot& corner : given.corners) corners.push_back({corner.x, corner.y});
  return corners;
}

// REQUIRES: it is a rectangle.
Result<Sheet> rectangle_of(const Bin& bin, Resolution resolution) {
  SheetParams params;
  params.width = bin.rectangle->y;
  params.length = bin.rectangle->x;
  return rectangle_of(params, resolution, bin.outline.field);
}

Result<std::vector<SheetZone>> zones_of(const Bin& bin, calls::Point origin, Resolution resolution) {
  std::vector<SheetZone> zones;
  for (const formats::jagua::BinZone& given : bin.zones) {
    auto zone = polygon_of(corners_of(given.outline), origin, resolution, given.outline.field);
    if (!zone) return zone.error();
    zones.push_back({*std::move(zone), given.quality});
  }
  return zones;
}

Result<Sheet> sheet_of(const Bin& bin, Resolution resolution) {
  const Corners corners = corners_of(bin.outline);
  const calls::Point origin = low_corner(corners);
  const auto outline = polygon_of(corners, origin, resolution, bin.outline.field);
  if (!outline) return outline.error();
  auto zones = zones_of(bin, origin, resolution);
  if (!zones) return zones.error();
  Sheet sheet = selvage::nesting::sheets::sheet_within(*outline, *std::move(zones));
  if (bin.rectangle) {  // it has no walls, may have a margin, and is rounded down
    const auto rectangle = rectangle_of(bin, resolution);
    if (!rectangle) return rectangle.error();
    sheet.outline.reset();
    sheet.width = rectangle->width;
    sheet.length = rectangle->length;
  }
  sheet.count = bin.count;
  sheet.cost = bin.cost;
  return sheet;
}

Result<std::vector<GivenSheet>> sheets_of_bins(const Json& listed, Resolution resolution) {
  const auto bins = formats::jagua::read_bins(listed);
  if (!bins) return bins.error();
  if (bins->empty() || bins->size() > kMostSheets) {
    return Error{ErrorCode::kOutOfRange,
                 std::to_string(bins->size()) + " kinds of bins are in stock; 1 to 100 are allowed", "/bins"};
  }
  std::vector<GivenSheet> given;
  for (const Bin& bin : *bins) {
    auto sheet = sheet_of(bin, resolution);
    if (!sheet) return sheet.error();
    given.push_back({*std::move(sheet), bin.field, bin.outline.field});
  }
  return given;
}

}  // namespace

Result<std::vector<GivenSheet>> sheets_of(const std::optional<std::vector<SheetParams>>& params,
                                          const MarkerFile& file) {
  const Resolution resolution = file.marker.resolution;
  if (!params) {
    if (const Json* const bins = file.attributes.whole.find("bins")) return sheets_of_bins(*bins, resolution);
    return Error{ErrorCode::kMissingField,
                 "is missing, and the opened file has no bins; 1 to 100 kinds of sheets are allowed", "/sheets"};
  }
  std::vector<GivenSheet> given;
  for (const SheetParams& one : *params) {
    const std::string field = "/sheets/" + std::to_string(given.size());
    auto sheet = sheet_of(one, resolution, field);
    if (!sheet) return sheet.error();
    given.push_back({*std::move(sheet), field, field + "/outline"});
  }
  return given;
}

Error with_field_of(Error error, const std::vector<GivenSheet>& sheets) {
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    const std::string own = "/sheets/" + std::to_string(k);
    if (error.field == own) error.field = sheets[k].field;
    if (error.field == own + "/outline") error.field = sheets[k].outline_field;
  }
  return error;
}

}  // namespace selvage::protocol::methods::nesting
