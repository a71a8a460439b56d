#include "core/packing/coverings/covering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/outline/outline.h"
#include "tests/support/polygons.h"

namespace selvage::packing::coverings {
namespace {

using Cover = std::vector<ConvexSet> (*)(const WedgeRing&);

WedgeRing ring_of(const Polygon& p, const Polygon& q) {
  SumCache sums;
  const auto obstacle = sums.obstacle({sums.outline(p), {}}, {sums.outline(q), {}});
  return {obstacle.sum().rings().front(), obstacle, {}};
}

// The number of sets that contain the point at a depth of more than `margin` units.
std::size_t sets_with(const std::vector<ConvexSet>& sets, RealVec p, double margin) {
  return static_cast<std::size_t>(std::ranges::count_if(sets, [&](const ConvexSet& set) {
    return std::ranges::all_of(set, [&](const HalfPlane& side) { return side.room(p) >= margin; });
  }));
}

// How deep the point lies inside a star-shaped ring, measured in the wedge that faces it.
double depth_in(const WedgeRing& ring, RealVec p) {
  return ring.depth(ring.facing(p), p);
}

// Calls `check(sets, point, depth)` for many points about the rings of random pieces.
template <class Check>
void for_random_points(Cover cover, const Check& check) {
  test::Random random{11};
  for (int trial = 0; trial < 60; ++trial) {
    const Coord extent = Coord{1} << random.between(12, 34);
    SumCache sums;
    const auto p = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
    const auto q = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
    const auto obstacle = sums.obstacle({p, random.symmetry()}, {q, random.symmetry()});
    for (const auto& sum : obstacle.sum().rings()) {
      const WedgeRing ring{sum, obstacle, {}};
      const auto sets = cover(ring);
      for (int k = 0; k < 100; ++k) {
        const RealVec at = geometry::real(random.point(-2 * extent, 2 * extent));
        check(sets, at, depth_in(ring, at));
      }
    }
  }
}

class Covering : public testing::TestWithParam<Cover> {};

// Laws (1) and (2) of the header.
TEST_P(Covering, CoversTheOutsideAndNoMore) {
  int inside = 0;
  int outside = 0;
  for_random_points(GetParam(), [&](const auto& sets, RealVec at, double depth) {
    const std::size_t count = sets_with(sets, at, 0);
    EXPECT_TRUE(depth >= 0 || count >= 1) << at.x << " " << at.y;
    EXPECT_TRUE(depth <= 64 || count == 0) << at.x << " " << at.y;
    inside += depth > 64 ? 1 : 0;
    outside += depth < 0 ? 1 : 0;
  });
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

INSTANTIATE_TEST_SUITE_P(All, Covering, testing::Values(&wedges, &walk, &slices));

class DisjointCovering : public testing::TestWithParam<Cover> {};

// Law (3).
TEST_P(DisjointCovering, SharesOnlyBorders) {
  for_random_points(GetParam(), [&](const auto& sets, RealVec at, double) {
    EXPECT_LE(sets_with(sets, at, 64), 1U) << at.x << " " << at.y;
  });
}

INSTANTIATE_TEST_SUITE_P(All, DisjointCovering, testing::Values(&wedges, &slices));

// Two squares: the walk takes the half-plane beyond each side; slices also one on each side and two between.
TEST(Coverings, OfSquares) {
  const Polygon square{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const WedgeRing ring = ring_of(square, square);
  EXPECT_EQ(wedges(ring).size(), 4U);
  EXPECT_EQ(walk(ring).size(), 4U);
  EXPECT_TRUE(std::ranges::all_of(walk(ring), [](const ConvexSet& set) { return set.size() == 1; }));
  EXPECT_EQ(slices(ring).size(), 4U);
}

// An L and a square: one set of the walk has both edges of the inner corner, so the walk has one set fewer than edges.
TEST(Coverings, TheWalkTakesAnInnerCornerInOneSet) {
  const Polygon square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const Polygon angle{{0, 0}, {1000, 0}, {1000, 500}, {500, 500}, {500, 1000}, {0, 1000}};
  const WedgeRing ring = ring_of(angle, square);
  EXPECT_EQ(wedges(ring).size(), 6U);
  EXPECT_EQ(walk(ring).size(), 5U);
}

}  // namespace
}  // namespace selvage::packing::coverings
