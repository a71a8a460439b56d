// Fuzz target: Minkowski sums of any two polygons, compared with CGAL's.
#include "core/minkowski/sum.h"

#include "tests/core/minkowski/sum_laws.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/geometry/any_polygon.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

// A polygon of one of the kinds used in tests, or an arbitrary one.  Polygons on a small lattice are scaled up.
Polygon any_polygon(Random& random, Coord extent) {
  if (random.chance(30)) return random_polygon(random, extent);
  const auto clean = clean_polygon(any_vertices(random, 16, extent));
  return clean ? clean->polygon : Polygon{{0, 0}, {extent, 0}, {0, extent}};
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  test::Random random{std::span{bytes, size}};
  const Coord factor = random.between(1000, 1'000'000);
  const Polygon p = test::scaled(test::any_polygon(random, random.between(4, 32)), factor);
  const Polygon q =
      transformed(test::scaled(test::any_polygon(random, random.between(2, 24)), factor), random.symmetry());
  const auto sum = minkowski::minkowski_sum(outline::make_outline(p)->parts, outline::make_outline(q)->parts);
  const std::string broken = test::broken_law({p, q, {}}, sum);
  test::demand(broken.empty(), broken);
  return 0;
}
