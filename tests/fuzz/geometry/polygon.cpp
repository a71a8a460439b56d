// Fuzz target: raw outlines.  The result of clean_polygon must be a Polygon, and everything computed from it must
// satisfy its contract.
#include "core/geometry/polygon.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/orientation.h"
#include "core/outline/decomposition/triangulation.h"
#include "core/outline/outline.h"
#include "core/outline/outward.h"
#include "core/outline/star.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/geometry/any_polygon.h"
#include "tests/judge/exact_pairs.h"

namespace selvage::test {
namespace {

void judge_polygon(const Polygon& polygon, const std::vector<Vec>& vertices) {
  const std::size_t n = polygon.size();
  demand(n >= 3, "a polygon has fewer than three vertices");
  for (std::size_t k = 0; k < n; ++k) {
    const Vec a = polygon[k];
    const Vec b = polygon[(k + 1) % n];
    const Vec c = polygon[(k + 2) % n];
    demand(a != b && geometry::cross({b.x - a.x, b.y - a.y}, {c.x - b.x, c.y - b.y}) != 0, "a vertex is redundant");
    demand(std::find(vertices.begin(), vertices.end(), a) != vertices.end(), "a vertex is not in the input");
    demand(locate(a, polygon) == geometry::Location::kBoundary, "a vertex is not on the boundary");
  }
  demand(!touches_itself(polygon), "a polygon touches itself");
  demand(doubled_area(polygon) > 0, "a polygon is clockwise");
  const auto again = clean_polygon(polygon);
  demand(again && again->polygon == polygon && again->repairs == geometry::Repairs{},
         "cleaning a clean polygon changes it");
}

Wide area_of_parts(const std::vector<outline::StarPart>& parts) {
  return std::accumulate(parts.begin(), parts.end(), Wide{},
                         [](Wide sum, const outline::StarPart& part) { return sum + doubled_area(part.vertices); });
}

void judge_outline(const Polygon& polygon) {
  const auto outline = outline::make_outline(polygon);
  demand(outline->convex == is_convex(polygon), "the outline's convexity is wrong");
  demand(area_of_parts(outline->parts) == doubled_area(polygon), "the areas of the star-shaped parts do not add up");
}

void judge_simplified(const Polygon& polygon, Coord tolerance) {
  const Polygon grown = outline::simplified_outward(polygon, tolerance);
  const auto again = clean_polygon(grown);
  demand(again && again->polygon == grown && again->repairs == geometry::Repairs{},
         "a simplified polygon is not clean");
  demand(grown.size() <= polygon.size(), "a simplified polygon has more vertices");
  demand(doubled_area(grown) >= doubled_area(polygon), "a simplified polygon has a smaller area");
  for (const Vec v : polygon)
    demand(locate(v, grown) != geometry::Location::kOutside, "a vertex lies outside the simplified polygon");
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  test::Random random{std::span{bytes, size}};
  const std::vector<Vec> vertices = test::any_vertices(random, 60, kLatticeLimit - 1);
  const auto clean = clean_polygon(vertices);
  std::vector<Vec> backwards{vertices.rbegin(), vertices.rend()};
  test::demand(static_cast<bool>(clean_polygon(backwards)) == static_cast<bool>(clean),
               "clockwise and counter-clockwise input are treated differently");
  if (!clean) {
    test::demand(!clean.error().message.empty(), "an outline was rejected without an error message");
    return 0;
  }
  test::judge_polygon(clean->polygon, vertices);
  test::judge_outline(clean->polygon);
  test::judge_simplified(clean->polygon, Coord{1} << random.below(40));
  const Orientation orientation{random.chance(50), Angle::of_degrees(360 * random.part()), {}};
  const Polygon turned_polygon = oriented(clean->polygon, orientation);
  if (const auto still = clean_polygon(turned_polygon)) test::judge_polygon(still->polygon, turned_polygon);
  return 0;
}
