// Tests of nearest_edges.h and of MinkowskiSum::contains.
#include "core/minkowski/nearest_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

double distance_to(const minkowski::convolution::SumEdge& e, Vec p) {
  const auto dx = static_cast<double>(e.to.x - e.from.x);
  const auto dy = static_cast<double>(e.to.y - e.from.y);
  const auto x = static_cast<double>(p.x - e.from.x);
  const auto y = static_cast<double>(p.y - e.from.y);
  const double t = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - t * dx, y - t * dy);
}

minkowski::MinkowskiSum random_sum(Random& random) {
  const Polygon p = random_polygon(random, 10'000);
  return minkowski::minkowski_sum(outline::star_parts(p), outline::star_parts(random_polygon(random, 10'000)));
}

Vec near(const Box& box, Random& random) {
  return {random.between(box.low.x - 5000, box.high.x + 5000), random.between(box.low.y - 5000, box.high.y + 5000)};
}

constexpr auto kSkipNothing = [](const Box&) { return false; };

TEST(NearestEdges, AreAllEdgesWithinReachInOrder) {
  Random random{131};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const minkowski::MinkowskiSum sum = random_sum(random);
    const Vec from = near(sum.box(), random);
    const double reach = random.chance(30) ? std::numeric_limits<double>::infinity() : random.part() * 10'000;
    minkowski::NearestEdges edges{sum, from, reach};
    std::set<const minkowski::convolution::SumEdge*> seen;
    double last = 0;
    while (const auto next = edges.next(kSkipNothing)) {
      const double distance = distance_to(*next->edge, from);
      ASSERT_NEAR(std::sqrt(next->squared_distance), distance, 1e-6);
      ASSERT_GE(distance, last - 1e-6);
      ASSERT_TRUE(seen.insert(next->edge).second);
      last = distance;
    }
    for (const minkowski::convolution::SumEdge& e : sum.edges()) {
      if (std::abs(distance_to(e, from) - reach) < 1e-6) continue;
      ASSERT_EQ(seen.contains(&e), distance_to(e, from) < reach);
    }
  }
}

TEST(NearestEdges, LeaveOutOnlySkippedBoxes) {
  Random random{132};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const minkowski::MinkowskiSum sum = random_sum(random);
    const Vec from = near(sum.box(), random);
    const Coord line = near(sum.box(), random).x;
    minkowski::NearestEdges edges{sum, from, std::numeric_limits<double>::infinity()};
    std::set<const minkowski::convolution::SumEdge*> seen;
    while (const auto next = edges.next([&](const Box& box) { return box.high.x < line; })) seen.insert(next->edge);
    for (const minkowski::convolution::SumEdge& e : sum.edges()) {
      ASSERT_TRUE(std::max(e.from.x, e.to.x) < line || seen.contains(&e));
    }
  }
}

TEST(NearestBoundaryPoint, IsNotFartherThanAnyEdge) {
  Random random{133};
  for (int trial = 0; trial < 1000 / kSlowdown; ++trial) {
    const minkowski::MinkowskiSum sum = random_sum(random);
    const Vec from = near(sum.box(), random);
    const minkowski::BoundaryPoint nearest = nearest_boundary_point(sum, from);
    double least = std::numeric_limits<double>::infinity();
    for (const minkowski::convolution::SumEdge& e : sum.edges()) least = std::min(least, distance_to(e, from));
    ASSERT_NEAR(nearest.distance, least, 1e-6);
    ASSERT_NEAR(std::hypot(nearest.at.x - static_cast<double>(from.x), nearest.at.y - static_cast<double>(from.y)),
                least, 1e-6);
    ASSERT_NEAR(distance_to(*nearest.edge, from), least, 1e-6);
  }
}

// On lattices so small that edges of one unit are rounding, nothing is guaranteed, but nothing may fail.
TEST(NearestBoundaryPoint, IsDefinedForTheSmallestSums) {
  Random random{134};
  for (int trial = 0; trial < 4000 / kSlowdown; ++trial) {
    const Polygon p = random_simple(random, 12, random.between(1, 6));
    const minkowski::MinkowskiSum sum = minkowski::minkowski_sum(
        outline::star_parts(p), outline::star_parts(random_simple(random, 12, random.between(1, 6))));
    ASSERT_FALSE(sum.edges().empty()) << text_of(p);
    EXPECT_LT(nearest_boundary_point(sum, {0, 0}).distance, 20);
  }
}

TEST(Contains, AgreesWithTheExactSumAwayFromTheBoundary) {
  Random random{135};
  std::size_t inside = 0;
  std::size_t outside = 0;
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 10'000);
    const Polygon q = random_polygon(random, 10'000);
    const minkowski::MinkowskiSum sum = minkowski::minkowski_sum(outline::star_parts(p), outline::star_parts(q));
    const ExactSum exact{p, q, ExactSum::Method::kConvolution};
    for (int k = 0; k < 40; ++k) {
      const Vec v = near(sum.box(), random);
      if (nearest_boundary_point(sum, v).distance < 3) continue;
      const RealVec at{static_cast<double>(v.x), static_cast<double>(v.y)};
      ASSERT_EQ(sum.contains(at), exact.locate(at) == geometry::Location::kInside)
          << text_of(p) << "; " << text_of(q) << " at " << text_of({v});
      ++(sum.contains(at) ? inside : outside);
    }
  }
  EXPECT_GT(inside, 2000U / kSlowdown);
  EXPECT_GT(outside, 2000U / kSlowdown);
}

}  // namespace
}  // namespace selvage::test
