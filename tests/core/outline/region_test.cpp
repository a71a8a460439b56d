// Tests of core/outline/region.h: area, point location and inner points of regions with holes.
#include "core/outline/region.h"

#include <gtest/gtest.h>

namespace selvage::outline {
namespace {

// A square frame whose right side is thicker.
const Region kFrame{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{{10, 10}, {10, 90}, {50, 90}, {50, 10}}}};

TEST(Region, AreaExcludesTheHoles) {
  EXPECT_EQ(area_of(kFrame), 100 * 100 - 40 * 80);
  const Coord far = Coord{1} << 40;  // so large that products in doubles would lose the difference
  EXPECT_EQ(area_of({{{far, far}, {far + 1, far}, {far, far + 1}}, {}}), 0.5);
}

TEST(Region, LocatesPoints) {
  EXPECT_EQ(locate({5, 5}, kFrame), geometry::Location::kInside);
  EXPECT_EQ(locate({20, 20}, kFrame), geometry::Location::kOutside);
  EXPECT_EQ(locate({10, 20}, kFrame), geometry::Location::kBoundary);
  EXPECT_EQ(locate({0, 20}, kFrame), geometry::Location::kBoundary);
  EXPECT_EQ(locate({-1, 20}, kFrame), geometry::Location::kOutside);
}

TEST(Region, PointInsideIsFarFromTheBoundary) {
  const Vec point = point_inside(kFrame);
  EXPECT_NEAR(static_cast<double>(point.x), 75, 1);
  EXPECT_GT(point.y, 20);
  EXPECT_LT(point.y, 80);
  const Region sliver{{{0, 0}, {1, 0}, {0, 1}}, {}};  // contains no lattice point except its vertices
  EXPECT_EQ(point_inside(sliver), (Vec{0, 0}));
}

}  // namespace
}  // namespace selvage::outline
