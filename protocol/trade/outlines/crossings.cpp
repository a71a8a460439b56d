#include "protocol/trade/outlines/crossings.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.h"
#include "core/outline/set_operations.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::outlines {
namespace {

using document::Spot;

constexpr double kPerMillimetre = 1e5;  // of the lattice on which the boundary is found
constexpr double kMostArea = 100, kMostPart = 0.01;
constexpr double kFarthest = 1e6;  // of a corner from the first one: no piece is so long

// The area in square millimetres.
double area_of(const Polygon& polygon) {
  return std::abs(static_cast<double>(geometry::doubled_area(polygon))) / 2 / kPerMillimetre / kPerMillimetre;
}

}  // namespace

std::optional<std::string> uncross(std::vector<Spot>& outline, const std::string& piece) {
  if (outline.size() < 3) return std::nullopt;
  const Spot origin = outline.front();
  Polygon polygon;
  for (const Spot& point : outline) {
    const Spot from{point.x - origin.x, point.y - origin.y};
    if (!(std::max(std::abs(from.x), std::abs(from.y)) <= kFarthest)) return std::nullopt;
    polygon.push_back({std::llround(from.x * kPerMillimetre), std::llround(from.y * kPerMillimetre)});
  }
  const auto clean = geometry::clean_polygon(polygon);
  if (clean || clean.error().code != ErrorCode::kSelfIntersecting) return std::nullopt;
  const auto outer = geometry::clean_polygon(outline::outer_boundary(polygon));
  if (!outer) return std::nullopt;
  const double before = area_of(polygon), change = std::abs(area_of(outer->polygon) - before);
  if (change > kMostArea || change > kMostPart * before) return std::nullopt;
  outline.clear();
  for (const Vec corner : outer->polygon) {
    outline.push_back({static_cast<double>(corner.x) / kPerMillimetre + origin.x,
                       static_cast<double>(corner.y) / kPerMillimetre + origin.y});
  }
  return "piece " + json::shortened(Json(piece)) + ": its outline crosses or touches itself; small loops of " +
         json::number_text(std::round(change * 1000) / 1000) + " mm2 are left out or filled";
}

}  // namespace selvage::protocol::trade::outlines
