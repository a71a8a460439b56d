#include "core/nesting/sheets/sheet.h"

#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/outline/enclosed/container.h"
#include "core/outline/enclosed/free_area.h"

namespace selvage::nesting::sheets {
namespace {

using outline::enclosed::Container;

// Adds zones with ids that neither a shape nor a piece of the marker has.
class ZoneAdder {
 public:
  ZoneAdder(Marker& to, const Marker& named) : to_{to} {
    for (const Shape& shape : named.shapes) used_.insert(shape.id);
    for (const auto* pieces : {&named.pieces, &named.unplaced}) {
      for (const Piece& piece : *pieces) used_.insert(piece.id);
    }
  }

  void add(Polygon outline, const std::string& name, std::optional<marker::Quality> quality) {
    std::size_t& number = numbers_[name];
    std::string id;
    do id = name + " " + std::to_string(++number);
    while (used_.contains(id));
    to_.pieces.push_back({.id = id,
                          .shape = {static_cast<std::uint32_t>(to_.shapes.size())},
                          .orientation = {},
                          .at = {},
                          .locked = true,
                          .rules = {.zone = true, .quality = quality}});
    to_.shapes.push_back({.id = id, .outline = std::move(outline), .tilt_limit = {}});
  }

 private:
  Marker& to_;
  std::set<std::string> used_;
  std::map<std::string, std::size_t> numbers_;  // the last one of each name
};

}  // namespace

Sheet sheet_within(const Polygon& outline, std::vector<SheetZone> zones) {
  const Box box = box_of(outline);
  const Vec by = -box.low;
  Sheet sheet{.width = box.height(), .length = box.width(), .outline = moved(outline, by)};
  for (SheetZone& zone : zones) sheet.zones.push_back({moved(std::move(zone.outline), by), zone.quality});
  return sheet;
}

double area_of(const Sheet& sheet) {
  const Polygon rectangle{{0, 0}, {sheet.length, 0}, {sheet.length, sheet.width}, {0, sheet.width}};
  std::vector<Polygon> holes;
  for (const SheetZone& zone : sheet.zones) {
    if (!zone.quality) holes.push_back(zone.outline);
  }
  return outline::enclosed::free_area(sheet.outline.value_or(rectangle), holes);
}

Result<Marker> bare(const Marker& marker, const Sheet& sheet) {
  Strip strip = marker.strip;
  strip.width = sheet.width;
  strip.longest = sheet.length;
  const Box room = strip.room(sheet.length - strip.margin);
  if (room.width() <= 0 || room.height() <= 0) {
    return Error{ErrorCode::kOutOfRange, "the sheet has no room between its margins", ""};
  }
  if (sheet.outline && room != Box{{0, 0}, {sheet.length, sheet.width}}) {
    return Error{
        ErrorCode::kOutOfRange,
        "is given, and the marker has a margin or selvedges; sheets with an outline are allowed for markers without "
        "them",
        "/outline"};
  }
  if (sheet.outline && sheet.outline->size() > Container::kMostCorners) {
    return Error{ErrorCode::kTooManyVertices,
                 "has " + std::to_string(sheet.outline->size()) + " corners; up to " +
                     std::to_string(Container::kMostCorners) + " are allowed",
                 "/outline"};
  }
  Marker result = marker;
  result.pieces.clear();
  result.unplaced.clear();
  result.strip = strip;
  ZoneAdder zones{result, marker};
  if (sheet.outline) {
    Container inside{*sheet.outline};
    for (Polygon& wall : inside.walls) zones.add(std::move(wall), "sheet edge", {});
  }
  for (const SheetZone& zone : sheet.zones) {
    zones.add(zone.outline, zone.quality ? "sheet zone" : "sheet hole", zone.quality);
  }
  return result;
}

}  // namespace selvage::nesting::sheets
