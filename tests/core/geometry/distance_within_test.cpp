// Tests of distance_within and whole_distance_within (core/geometry/distance.h), on known cases and against CGAL.
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/distance.h"
#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

TEST(DistanceWithin, HasKnownValues) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(distance_within(placed(square), placed(square, {9, 1}), 100), 5);
  EXPECT_EQ(distance_within(placed(square), placed(square, {7, 8}), 100), 5);  // corner to corner: 3, 4, 5
  EXPECT_EQ(distance_within(placed(square), placed(square, {4, 4}), 100), 0);
  EXPECT_EQ(distance_within(placed(square), placed(square, {1, 1}), 100), 0);
  EXPECT_EQ(distance_within(placed(square), placed(square, {9, 1}), 3), 3);
  const Polygon inside{{1, 1}, {2, 1}, {2, 2}};
  EXPECT_EQ(distance_within(placed(square), placed(inside), 100), 0);
  EXPECT_EQ(whole_distance_within(placed(square), placed(square, {7, 7}), 100),
            4);  // the square root of 18, rounded down
  EXPECT_EQ(whole_distance_within(placed(square), placed(square, {7, 7}), 2), 2);
}

TEST(DistanceWithin, AgreesWithExactDistances) {
  Random random{54};
  std::size_t apart = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Coord factor = trial % 2 == 0 ? 1 : Coord{1} << random.between(20, 30);
    const Polygon p = scaled(random_polygon(random, 100), factor);
    const Polygon q = scaled(moved(random_polygon(random, 100), random.point(-150, 150)), factor);
    const Coord reach = 200 * factor;
    const Coord whole = whole_distance_within(placed(p), placed(q), reach);
    const double distance = distance_within(placed(p), placed(q), static_cast<double>(reach));
    ASSERT_EQ(distance, distance_within(placed(q), placed(p), static_cast<double>(reach)));
    ASSERT_NEAR(static_cast<double>(whole) + 0.5, distance, 0.5 + 1e-14 * distance);
    if (interiors_meet(p, q)) {
      ASSERT_EQ(whole, 0);
      continue;
    }
    ++apart;
    if (whole > 0) {
      ASSERT_GE(compare_distance(p, q, whole), 0);
    }
    if (whole < reach) {
      ASSERT_LT(compare_distance(p, q, whole + 1), 0);
    }
  }
  EXPECT_GT(apart, 1000U);
}

}  // namespace
}  // namespace selvage::test
