#include "protocol/formats/jagua/bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace selvage::protocol::formats::jagua {
namespace {

constexpr std::int64_t kMostInStock = 1'000;
constexpr std::size_t kMostZones = 1'000;  // of one bin, holes among them
constexpr json::Range kNumbers{-1e12, 1e12};

double number_of(const Json& value, const std::string& at, json::Mistake& mistake) {
  if (value.is_number() && value.number() >= kNumbers.least && value.number() <= kNumbers.most) return value.number();
  mistake.add(ErrorCode::kWrongType, json::shortened(value) + " is no number from -1e12 to 1e12", at);
  return 0;
}

BinPolygon read_polygon(const Json& corners, const std::string& at, json::Mistake& mistake) {
  BinPolygon polygon{{}, at};
  if (!corners.is_array()) mistake.add(ErrorCode::kWrongType, "is not a list of corners [x, y]", at);
  for (std::size_t k = 0; corners.is_array() && k < corners.size() && !mistake; ++k) {
    const std::string corner = at + "/" + std::to_string(k);
    if (!corners[k].is_array() || corners[k].size() != 2) {
      mistake.add(ErrorCode::kWrongType, json::shortened(corners[k]) + " is not a corner [x, y]", corner);
      break;
    }
    polygon.corners.push_back(
        {number_of(corners[k][0], corner + "/0", mistake), number_of(corners[k][1], corner + "/1", mistake)});
  }
  return polygon;
}

struct BinShape {
  BinPolygon outline;
  std::optional<document::Spot> rectangle{};
  std::vector<BinPolygon> holes;
};

BinShape read_rectangle(const Json& value, const std::string& at, json::Mistake& mistake) {
  json::Fields fields{value, at, mistake};
  const double x = fields.number("x_min", kNumbers), y = fields.number("y_min", kNumbers);
  const double width = fields.number("width", {0, kNumbers.most}), height = fields.number("height", {0, kNumbers.most});
  return {.outline = {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, at},
          .rectangle = document::Spot{width, height},
          .holes = {}};
}

BinShape read_shape(const Json& value, const std::string& at, json::Mistake& mistake) {
  json::Fields fields{value, at, mistake};
  const std::string type = fields.text("type");
  const std::string part = fields.pointer("data");
  if (type == "rectangle") return read_rectangle(fields.object("data"), part, mistake);
  if (type == "simple_polygon") return {read_polygon(fields.array("data"), part, mistake), std::nullopt, {}};
  if (type != "polygon") {
    mistake.add(ErrorCode::kOutOfRange,
                json::shortened(Json(type)) + " is not read; one of rectangle, simple_polygon, polygon is allowed",
                fields.pointer("type"));
    return {};
  }
  json::Fields polygon{fields.object("data"), part, mistake};
  BinShape shape{read_polygon(polygon.array("outer"), polygon.pointer("outer"), mistake), std::nullopt, {}};
  if (const Json* inner = polygon.maybe_array("inner")) {
    for (std::size_t k = 0; k < inner->size() && !mistake; ++k) {
      shape.holes.push_back(read_polygon((*inner)[k], polygon.pointer("inner") + "/" + std::to_string(k), mistake));
    }
  }
  return shape;
}

void add_zone(const Json& value, const std::string& at, Bin& bin, json::Mistake& mistake) {
  json::Fields fields{value, at, mistake};
  const auto quality = fields.maybe_integer("quality", 0, kBestQuality);
  if (!quality)
    mistake.add(ErrorCode::kMissingField, "is missing; a quality from 0 to 10 is allowed", fields.pointer("quality"));
  const BinShape shape = read_shape(fields.object("shape"), fields.pointer("shape"), mistake);
  if (!quality || *quality == kBestQuality) return;
  bin.zones.push_back({shape.outline, *quality == 0 ? std::nullopt : std::optional{class_of(*quality)}});
}

Bin read_bin(const Json& value, const std::string& at, json::Mistake& mistake) {
  json::Fields fields{value, at, mistake};
  BinShape shape = read_shape(fields.object("shape"), fields.pointer("shape"), mistake);
  Bin bin{.field = at,
          .outline = std::move(shape.outline),
          .rectangle = shape.rectangle,
          .zones = {},
          .count = 1,
          .cost = 1};
  for (BinPolygon& hole : shape.holes) bin.zones.push_back({std::move(hole), std::nullopt});
  if (const Json* zones = fields.maybe_array("zones")) {
    for (std::size_t k = 0; k < zones->size() && !mistake; ++k) {
      add_zone((*zones)[k], fields.pointer("zones") + "/" + std::to_string(k), bin, mistake);
    }
  }
  if (bin.zones.size() > kMostZones) {
    mistake.add(ErrorCode::kOutOfRange,
                "has " + std::to_string(bin.zones.size()) + " holes and zones; up to 1,000 are allowed", at);
  }
  const double stock = fields.number_or("stock", 1, {0, std::numeric_limits<double>::max()});
  if (stock != std::floor(stock)) mistake.add(ErrorCode::kOutOfRange, "is no whole number", fields.pointer("stock"));
  bin.cost = fields.number_or("cost", 1, {0, kNumbers.most});
  bin.count = static_cast<std::size_t>(std::min(stock, static_cast<double>(kMostInStock)));
  return bin;
}

}  // namespace

marker::Quality class_of(std::int64_t quality) {
  return static_cast<marker::Quality>(std::clamp<std::int64_t>(kBestQuality - quality, 0, kBestQuality - 1));
}

Result<std::vector<Bin>> read_bins(const Json& bins) {
  json::Mistake mistake;
  std::vector<Bin> read;
  if (!bins.is_array()) return Error{ErrorCode::kWrongType, "is not a list of bins", "/bins"};
  for (std::size_t k = 0; k < bins.size() && !mistake; ++k) {
    Bin bin = read_bin(bins[k], "/bins/" + std::to_string(k), mistake);
    if (bin.count > 0) read.push_back(std::move(bin));
  }
  if (mistake) return mistake.error();
  return read;
}

double widest(const std::vector<Bin>& bins) {
  double most = 0;
  for (const Bin& bin : bins) {
    const auto [low, high] =
        std::minmax_element(bin.outline.corners.begin(), bin.outline.corners.end(),
                            [](const document::Spot& a, const document::Spot& b) { return a.y < b.y; });
    if (low != bin.outline.corners.end()) most = std::max(most, high->y - low->y);
  }
  return most;
}

}  // namespace selvage::protocol::formats::jagua
