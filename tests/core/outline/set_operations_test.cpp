// Tests of core/outline/set_operations.h: regions left over in a box, and grown outlines, against CGAL.
#include "core/outline/set_operations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::outline {
namespace {

using test::Random;

Polygon square(Vec at, Coord side) {
  return {at, {at.x + side, at.y}, {at.x + side, at.y + side}, {at.x, at.y + side}};
}

TEST(Widened, GrowsOnTheGivenSides) {
  const auto widened = [](const Polygon& polygon, const Box& by) {
    return clean_polygon(outline::widened(polygon, by))->polygon;  // without vertices in the middle of its edges
  };
  EXPECT_EQ(widened(square({0, 0}, 10), {{-2, 0}, {3, 5}}), (Polygon{{-2, 0}, {13, 0}, {13, 15}, {-2, 15}}));
  EXPECT_EQ(widened(square({0, 0}, 10), {}), square({0, 0}, 10));
  const Polygon triangle{{0, 0}, {20, 0}, {0, 10}};
  EXPECT_EQ(widened(triangle, {{0, 0}, {4, 0}}), (Polygon{{0, 0}, {24, 0}, {4, 10}, {0, 10}}));
}

// A star-shaped outline has a star-shaped sum, without holes.
TEST(Widened, IsTheMinkowskiSumWithTheBox) {
  Random random{11};
  for (int k = 0; k < 100 / test::kSlowdown; ++k) {
    const Coord extent = Coord{1} << random.between(10, 30);
    const Polygon polygon = test::random_star(random, 12, extent);
    const auto length = [&] { return random.between(1, extent / 3); };
    const Box by{{-length(), -length()}, {length(), length()}};
    const Polygon wide = widened(polygon, by);
    ASSERT_TRUE(clean_polygon(wide));
    const Polygon rectangle{by.low, {by.high.x, by.low.y}, by.high, {by.low.x, by.high.y}};
    // Corners are rounded to the lattice: about a unit on either side of the boundary.
    EXPECT_LE(test::ExactSum(polygon, rectangle, test::ExactSum::Method::kDecomposition)
                  .difference(std::vector<Polygon>{wide})
                  .area,
              20.0 * static_cast<double>(extent));
  }
}

TEST(LeftOver, IsTheWholeBoxWhenNothingIsTaken) {
  const auto regions = left_over({{0, 0}, {30, 20}}, {});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].outline, (Polygon{{0, 0}, {30, 0}, {30, 20}, {0, 20}}));
}

TEST(LeftOver, FindsHolesAndIslands) {  // a frame inside the box: a ring around it, and an island within it
  const std::vector<Polygon> frame{square({10, 10}, 20), {{15, 15}, {15, 25}, {25, 25}, {25, 15}}};
  const auto regions = left_over({{0, 0}, {40, 40}}, frame);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(area_of(regions[0]), 1600 - 400);
  ASSERT_EQ(regions[0].holes.size(), 1U);
  EXPECT_LT(doubled_area(regions[0].holes[0]), 0);
  EXPECT_EQ(regions[1], (Region{square({15, 15}, 10), {}}));
}

TEST(LeftOver, DoesNotDependOnTheOrderOfPolygons) {
  Random random{5};
  std::vector<Polygon> taken;
  for (int k = 0; k < 12; ++k) {
    taken.push_back(test::random_polygon(random, 400));
    const Vec by = random.point(0, 800);
    for (Vec& v : taken.back()) v = v + by;
  }
  const auto regions = left_over({{0, 0}, {1000, 1000}}, taken);
  std::reverse(taken.begin(), taken.end());
  const auto again = left_over({{0, 0}, {1000, 1000}}, taken);
  EXPECT_TRUE(std::is_sorted(regions.begin(), regions.end()));
  ASSERT_EQ(regions.size(), again.size());
  for (std::size_t k = 0; k < regions.size(); ++k) EXPECT_NEAR(area_of(regions[k]), area_of(again[k]), 2000);
}

// Corners are rounded to the lattice, and each changes the area by at most about the length of its edges.
TEST(LeftOver, HasTheExactArea) {
  Random random{7};
  for (int trial = 0; trial < 600 / test::kSlowdown; ++trial) {
    const Coord extent = Coord{1} << random.between(10, 38);
    const Box box{{0, 0}, {4 * extent, 3 * extent}};
    std::vector<Polygon> taken;
    double perimeter = 14 * static_cast<double>(extent);
    for (int k = 0; k < 8; ++k) {
      taken.push_back(test::random_polygon(random, extent));
      const Vec by = random.point(-extent / 2, 3 * extent);
      Vec previous = taken.back().back() + by;
      for (Vec& v : taken.back()) {
        v = v + by;
        perimeter += std::hypot(static_cast<double>(v.x - previous.x), static_cast<double>(v.y - previous.y));
        previous = v;
      }
    }
    double area = 0;
    for (const Region& region : left_over(box, taken)) area += area_of(region);
    const auto exact = test::areas_left_over(box, taken);
    double exact_area = 0;
    for (const double part : exact) exact_area += part;
    const double rounding = 2 * perimeter + 1e-12 * exact_area;
    ASSERT_NEAR(area, exact_area, rounding) << "trial " << trial << " extent " << extent;
  }
}

TEST(Grown, ContainsAllPointsWithinTheDistance) {
  Random random{11};
  for (int trial = 0; trial < 2000 / test::kSlowdown; ++trial) {
    const Coord extent = Coord{1} << random.between(8, 38);
    const Polygon polygon = test::random_polygon(random, extent);
    const Coord distance = extent / random.between(20, 200) + 3;
    const auto rings = grown(polygon, distance);
    ASSERT_FALSE(rings.empty());
    // Except for rounding, no ring is nearer than the distance, and none is farther than a mitred corner.
    for (const Polygon& ring : rings) {
      Vec a = ring.back();
      for (const Vec b : ring) {
        const Vec middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        a = b;
        for (const Vec v : {b, middle}) {
          const Polygon speck{v, {v.x + 1, v.y}, {v.x, v.y + 1}};
          ASSERT_FALSE(closer_than(test::placed(polygon), test::placed(speck), distance - 3)) << trial;
        }
        const Polygon speck{b, {b.x + 1, b.y}, {b.x, b.y + 1}};
        ASSERT_TRUE(closer_than(test::placed(polygon), test::placed(speck), 2 * distance + 4)) << trial;
      }
    }
  }
}

TEST(Grown, ByZeroIsThePolygonItself) {
  EXPECT_EQ(grown(square({3, 4}, 5), 0), (std::vector<Polygon>{square({3, 4}, 5)}));
}

}  // namespace
}  // namespace selvage::outline
