#include "core/packing/bodies/spaced_rings.h"

#include <cmath>
#include <numbers>

#include "core/geometry/polygon.h"
#include "core/outline/outline.h"

namespace selvage::packing::bodies {
namespace {

constexpr int kCorners = 24;  // of the polygon inside the circle: it reaches 99.1 % of the radius everywhere

// Convex, so that on a coarse lattice the corners on the axes, which keep the whole radius, are no spikes.
Polygon inside_circle(Coord radius) {
  Polygon corners;
  for (int k = 0; k <= kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    const double r = static_cast<double>(radius) + 1e-9;
    const Vec corner{static_cast<Coord>(r * std::cos(angle)), static_cast<Coord>(r * std::sin(angle))};
    const auto is_flat = [&] {
      const Vec last = corners.back();
      return cross(last - corners[corners.size() - 2], corner - last) <= 0;
    };
    while (corners.size() >= 2 && is_flat()) corners.pop_back();
    if (k < kCorners) corners.push_back(corner);
  }
  return corners;
}

std::size_t true_edges(const minkowski::convolution::StarSum& sum) {
  std::size_t count = 0;
  for (const auto& edge : sum.edges) count += edge.from == edge.to ? 0 : 1;
  return count;
}

}  // namespace

std::optional<std::vector<cells::WedgeRing>> spaced_rings(const outline::OrientedOutline& p,
                                                          const outline::OrientedOutline& q, Coord spacing, Vec offset,
                                                          SumCache& sums, const std::stop_token& stop) {
  const auto found = sums.obstacle(p, q, stop);
  if (!found) return {};
  const minkowski::Obstacle& obstacle = *found;
  std::vector<cells::WedgeRing> rings;
  const auto add = [&](const minkowski::convolution::StarSum& sum) {
    if (true_edges(sum) >= 3) rings.emplace_back(sum, obstacle, offset);
  };
  const auto circle = spacing > 0 ? clean_polygon(inside_circle(spacing)) : Result<geometry::CleanPolygon>{Error{}};
  for (const minkowski::convolution::StarSum& sum : obstacle.sum().rings()) {
    if (stop.stop_requested()) return {};
    Polygon corners;
    for (const auto& edge : sum.edges) corners.push_back(edge.from);
    const auto clean = circle ? clean_polygon(corners) : Result<geometry::CleanPolygon>{Error{}};
    if (!clean) {  // no spacing, or one too small to matter: the ring itself lies in the forbidden region, too
      add(sum);
      continue;
    }
    const auto ring = outline::make_outline(clean->polygon);
    const auto disc = outline::make_outline(circle->polygon);
    const minkowski::MinkowskiSum grown = minkowski::minkowski_sum(ring->parts, disc->parts);
    for (const auto& part : grown.rings()) add(part);
  }
  return rings;
}

}  // namespace selvage::packing::bodies
