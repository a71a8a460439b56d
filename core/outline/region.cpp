#include "core/outline/region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace selvage::outline {
namespace {

constexpr Coord kChords = 24;

template <class Visit>
void for_each_edge(const Region& region, const Visit& visit) {
  const auto walk = [&visit](const Polygon& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) visit(ring[k], ring[(k + 1) % ring.size()]);
  };
  walk(region.outline);
  for (const Polygon& hole : region.holes) walk(hole);
}

double distance_to_boundary(Vec point, const Region& region) {
  double least = std::numeric_limits<double>::max();
  for_each_edge(region, [&](Vec a, Vec b) {
    const auto dx = static_cast<double>(b.x - a.x);
    const auto dy = static_cast<double>(b.y - a.y);
    const auto px = static_cast<double>(point.x - a.x);
    const auto py = static_cast<double>(point.y - a.y);
    const double part = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(px - part * dx, py - part * dy));
  });
  return least;
}

// The middle of the longest segment of the horizontal line at `y` that lies inside the region.
std::optional<Vec> middle_of_chord(const Region& region, Coord y) {
  std::vector<double> crossings;
  for_each_edge(region, [&](Vec a, Vec b) {
    if ((a.y > y) == (b.y > y)) return;
    const double part = static_cast<double>(y - a.y) / static_cast<double>(b.y - a.y);
    crossings.push_back(static_cast<double>(a.x) + part * static_cast<double>(b.x - a.x));
  });
  std::sort(crossings.begin(), crossings.end());
  std::optional<Vec> middle;
  double longest = 0;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const double length = crossings[k + 1] - crossings[k];
    if (length <= longest) continue;
    longest = length;
    middle = Vec{std::llround((crossings[k] + crossings[k + 1]) / 2), y};
  }
  return middle;
}

}  // namespace

double area_of(const Region& region) {
  Wide doubled = doubled_area(region.outline);
  for (const Polygon& hole : region.holes) doubled += doubled_area(hole);  // negative
  return static_cast<double>(doubled) / 2;
}

geometry::Location locate(Vec point, const Region& region) {
  const geometry::Location in_outline = locate(point, region.outline);
  if (in_outline != geometry::Location::kInside) return in_outline;
  for (const Polygon& hole : region.holes) {
    const geometry::Location in_hole = locate(point, hole);
    if (in_hole == geometry::Location::kInside) return geometry::Location::kOutside;
    if (in_hole == geometry::Location::kBoundary) return geometry::Location::kBoundary;
  }
  return geometry::Location::kInside;
}

Vec point_inside(const Region& region) {
  const Box box = box_of(region.outline);
  Vec best = region.outline.front();
  double farthest = 0;
  for (Coord k = 0; k < kChords; ++k) {
    const auto middle = middle_of_chord(region, box.low.y + box.height() * (2 * k + 1) / (2 * kChords));
    if (!middle || locate(*middle, region) != geometry::Location::kInside) continue;
    const double distance = distance_to_boundary(*middle, region);
    if (distance <= farthest) continue;
    farthest = distance;
    best = *middle;
  }
  return best;
}

}  // namespace selvage::outline
