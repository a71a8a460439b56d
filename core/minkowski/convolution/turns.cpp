#include "core/minkowski/convolution/turns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/geometry/pseudo_angle.h"

namespace selvage::minkowski::convolution {
namespace {

Direction direction_of(Vec v) {
  return {v, geometry::pseudo_angle(static_cast<double>(v.x), static_cast<double>(v.y))};
}

// Negative when a precedes b counter-clockwise from the x axis within one turn, positive when it follows; 0 when both
// have the same direction.
int order_of(const Direction& a, const Direction& b) {
  constexpr double kClear = 1e-12;
  if (std::abs(a.angle - b.angle) > kClear) return a.angle < b.angle ? -1 : 1;
  const Wide turn = cross(a.vector, b.vector);
  return static_cast<int>(turn < 0) - static_cast<int>(turn > 0);
}

}  // namespace

Turns::Turns(const Polygon& polygon) : edge(polygon.size()), convex(polygon.size()), by_direction(polygon.size()) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) edge[i] = direction_of(polygon[i + 1 == n ? 0 : i + 1] - polygon[i]);
  for (std::size_t i = 0; i < n; ++i) convex[i] = cross(edge[into(i)].vector, edge[i].vector) > 0;
  std::iota(by_direction.begin(), by_direction.end(), 0U);
  std::sort(by_direction.begin(), by_direction.end(), [&](auto i, auto j) {
    const int order = order_of(edge[i], edge[j]);
    return order < 0 || (order == 0 && i < j);
  });
}

std::vector<std::uint32_t> places(const Turns& of, const Turns& among, bool with_parallel) {
  std::vector<std::uint32_t> places(of.edge.size());
  const int first_after = with_parallel ? 1 : 0;
  std::uint32_t place = 0;
  for (const std::uint32_t e : of.by_direction) {
    while (place < among.by_direction.size() &&
           order_of(among.edge[among.by_direction[place]], of.edge[e]) < first_after) {
      ++place;
    }
    places[e] = place;
  }
  return places;
}

}  // namespace selvage::minkowski::convolution
