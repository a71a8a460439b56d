#include "core/matching/alignment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/outline/set_operations.h"

namespace selvage::matching {
namespace {

// Rounded towards the smaller coordinate, alike for all boxes.
Coord halved(Coord sum) {
  return sum >= 0 ? sum / 2 : (sum - 1) / 2;
}

Vec middle_of(const Box& box) {
  return {halved(box.low.x + box.high.x), halved(box.low.y + box.high.y)};
}

Vec centre_of_area(const Polygon& polygon) {
  const Vec origin = polygon.front();
  double x = 0;
  double y = 0;
  double doubled = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec a = polygon[k] - origin;
    const Vec b = polygon[k + 1] - origin;
    const auto weight = static_cast<double>(geometry::cross(a, b));
    x += weight * static_cast<double>(a.x + b.x);
    y += weight * static_cast<double>(a.y + b.y);
    doubled += weight;
  }
  return {origin.x + std::llround(x / (3 * doubled)), origin.y + std::llround(y / (3 * doubled))};
}

}  // namespace

double shared_area(const Polygon& first, const Polygon& second, Vec by) {
  Polygon moved = second;
  for (Vec& v : moved) v = v + by;
  const Box box = united(box_of(first), box_of(moved));
  double covered = static_cast<double>(box.width()) * static_cast<double>(box.height());
  for (const outline::Region& region : outline::left_over(box, {first, moved})) covered -= outline::area_of(region);
  return std::max(0.0, area_of(first) + area_of(second) - covered);
}

double symmetric_difference(const Polygon& first, const Polygon& second, Vec by) {
  const Vec start = *std::min_element(first.begin(), first.end());
  const Vec other = *std::min_element(second.begin(), second.end());
  if (first.size() == second.size() && start == other + by) {
    const auto a = std::find(first.begin(), first.end(), start) - first.begin();
    const auto b = std::find(second.begin(), second.end(), other) - second.begin();
    bool equal = true;
    for (std::size_t k = 0; k < first.size() && equal; ++k) {
      equal = first[(static_cast<std::size_t>(a) + k) % first.size()] ==
              second[(static_cast<std::size_t>(b) + k) % second.size()] + by;
    }
    if (equal) return 0;
  }
  return std::max(0.0, area_of(first) + area_of(second) - 2 * shared_area(first, second, by));
}

Alignment best_alignment(const Polygon& first, const Polygon& second) {
  const Box a = box_of(first);
  const Box b = box_of(second);
  const Vec low = a.low - b.low;
  const Vec high = a.high - b.high;
  const std::array candidates{
      middle_of(a) - middle_of(b), centre_of_area(first) - centre_of_area(second), low, high, Vec{low.x, high.y},
      Vec{high.x, low.y}};
  Alignment best{candidates[0], symmetric_difference(first, second, candidates[0])};
  for (const Vec by : candidates) {
    if (best.difference == 0) break;
    const double difference = symmetric_difference(first, second, by);
    if (difference < best.difference) best = {by, difference};
  }
  return best;
}

}  // namespace selvage::matching
