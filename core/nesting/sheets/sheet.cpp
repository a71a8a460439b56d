#include "core/nesting/sheets/sheet.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/outline/enclosed/container.h"

namespace selvage::nesting::sheets {
namespace {

Polygon moved(Polygon polygon, Vec by) {
  for (Vec& vertex : polygon) vertex = vertex + by;
  return polygon;
}

double area_of_polygon(const Polygon& polygon) {
  return static_cast<double>(doubled_area(polygon)) / 2;
}

void add_wall(Marker& marker, const Polygon& polygon, const std::string& id) {
  Shape shape;
  shape.id = id;
  shape.outline = polygon;
  Piece piece;
  piece.id = id;
  piece.shape = ShapeId{static_cast<std::uint32_t>(marker.shapes.size())};
  piece.locked = true;
  piece.overlap = 0;
  marker.shapes.push_back(std::move(shape));
  marker.pieces.push_back(std::move(piece));
}

}  // namespace

Sheet sheet_within(const Polygon& outline, std::vector<Polygon> holes) {
  const Box box = box_of(outline);
  const Vec by = -box.low;
  Sheet sheet{.width = box.height(), .length = box.width(), .outline = moved(outline, by)};
  for (Polygon& hole : holes) sheet.holes.push_back(moved(std::move(hole), by));
  return sheet;
}

double area_of(const Sheet& sheet) {
  double area = sheet.outline ? area_of_polygon(*sheet.outline)
                              : static_cast<double>(sheet.width) * static_cast<double>(sheet.length);
  for (const Polygon& hole : sheet.holes) area -= area_of_polygon(hole);
  return area;
}

Result<Marker> bare(const Marker& marker, const Sheet& sheet) {
  Strip strip = marker.strip;
  strip.width = sheet.width;
  strip.longest = sheet.length;
  const Box room = strip.room(sheet.length - strip.margin);
  if (room.width() <= 0 || room.height() <= 0) {
    return Error{ErrorCode::kOutOfRange, "the sheet has no room between its margins", ""};
  }
  if (!sheet.plain() && room != Box{{0, 0}, {sheet.length, sheet.width}}) {
    return Error{ErrorCode::kOutOfRange,
                 "an outline or holes are given, and the marker has a margin; sheets with an outline or holes are "
                 "allowed for markers without one: give the pieces buffers instead",
                 sheet.outline ? "/outline" : "/holes"};
  }
  Marker result = marker;
  result.pieces.clear();
  result.unplaced.clear();
  result.strip = strip;
  if (sheet.plain()) return result;
  result.spacing = 0;
  if (sheet.outline) {
    const outline::enclosed::Container container{*sheet.outline};
    for (const Polygon& wall : container.walls) {
      add_wall(result, wall, "wall " + std::to_string(result.pieces.size() + 1) + " of the sheet");
    }
  }
  const std::size_t walls = result.pieces.size();
  for (const Polygon& hole : sheet.holes) {
    const std::size_t index = result.pieces.size() - walls;
    add_wall(result, hole, "hole " + std::to_string(index + 1) + " of the sheet");
    const marker::PlacedPieces pieces{result};
    if (all_clear(pieces, result.strip)) continue;
    return Error{ErrorCode::kOutOfRange,
                 "overlaps another hole or reaches beyond the sheet; holes inside the sheet that at most touch are "
                 "allowed",
                 "/holes/" + std::to_string(index)};
  }
  return result;
}

Piece on_sheet(Piece piece, const Marker& marker, const Sheet& sheet) {
  if (!sheet.plain()) piece.buffer = std::max(piece.buffer, (marker.spacing + 1) / 2);
  return piece;
}

}  // namespace selvage::nesting::sheets
