#include "core/packing/bodies/lattice_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/polygons.h"

namespace selvage::packing::bodies {
namespace {

constexpr RealBox kWide{-1e6, -1e6, 1e6, 1e6};

// The half-plane to the left of the line through two points.
cells::HalfPlane left_of(RealVec from, RealVec to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double nx = (from.y - to.y) / length;
  const double ny = (to.x - from.x) / length;
  return {nx, ny, nx * from.x + ny * from.y};
}

TEST(LatticePointNear, IsThePointItselfWhereThatIsFree) {
  const std::vector planes{left_of({0, 0}, {10, 1})};
  const auto point = lattice_point_near({5, 40}, planes, kWide);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->x, 5);
  EXPECT_EQ(point->y, 40);
}

// Between two lines that coincide there is a point every (300, 101) units.
TEST(LatticePointNear, LiesInASlotWithoutWidth) {
  const std::vector planes{left_of({0, 0}, {300, 101}), left_of({300, 101}, {0, 0})};
  const auto point = lattice_point_near({430, 145}, planes, kWide);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->x, 300);
  EXPECT_EQ(point->y, 101);
  EXPECT_FALSE(lattice_point_near({430, 145}, planes, {301, -1e6, 599, 1e6}));
}

// Whatever the direction of the slot, and wherever the one point in reach is that it holds.
TEST(LatticePointNear, KeepsAllHalfPlanes) {
  test::Random random{8};
  int found = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const RealVec from = geometry::real(random.point(-1000, 1000));
    std::vector<cells::HalfPlane> planes;
    for (int k = 0; k < 4; ++k) {
      const RealVec a = geometry::real(random.point(-1000, 1000));
      const RealVec b = geometry::real(random.point(-1000, 1000));
      if (a.x != b.x || a.y != b.y) planes.push_back(left_of(a, b));
    }
    const auto point = lattice_point_near(from, planes, kWide);
    if (!point) continue;
    ++found;
    EXPECT_EQ(point->x, std::round(point->x));
    EXPECT_EQ(point->y, std::round(point->y));
    for (const auto& plane : planes) EXPECT_GE(plane.room(*point), -1e-3) << "trial " << trial;
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace selvage::packing::bodies
