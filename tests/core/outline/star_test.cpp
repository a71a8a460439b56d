// Tests of core/outline/star.h: kernel points, and the partition of polygons into star-shaped parts.
#include "core/outline/star.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

// Rounded to multiples of 2^-40, kernel points become integers for exact tests.
using Integer = boost::multiprecision::int256_t;
constexpr int kBits = 40;
Integer fixed_point(double value) {
  return Integer{static_cast<std::int64_t>(std::floor(value))} * (Integer{1} << kBits) +
         Integer{static_cast<std::int64_t>((value - std::floor(value)) * 0x1p40)};
}

// True when the point lies strictly to the left of every edge's line.  Exact.
bool sees_every_edge(RealVec point, const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i];
    const Vec d = polygon[(i + 1) % polygon.size()] - a;
    const Integer unit = Integer{1} << kBits;
    const Integer x = fixed_point(point.x) - Integer{a.x} * unit;
    const Integer y = fixed_point(point.y) - Integer{a.y} * unit;
    if (Integer{Integer{d.x} * y} <= Integer{Integer{d.y} * x}) return false;
  }
  return true;
}

TEST(KernelPoint, ExistsExactlyForStarShapedPolygons) {
  EXPECT_TRUE(outline::kernel_point({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  const auto l_shape = outline::kernel_point({{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}});
  ASSERT_TRUE(l_shape);
  EXPECT_NEAR(l_shape->x, 1, 1e-9);  // the kernel is the square at the corner
  EXPECT_NEAR(l_shape->y, 1, 1e-9);
  EXPECT_FALSE(outline::kernel_point({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}}));  // a U
  // Star-shaped only about the single point (4, 4): the kernel has no depth.
  EXPECT_FALSE(outline::kernel_point({{0, 0}, {4, 4}, {8, 0}, {4, 4 + 1}, {8, 8}, {4, 5}, {0, 8}, {3, 4}}));
}

TEST(KernelPoint, SeesEveryEdge) {
  Random random{71};
  std::size_t found = 0;
  for (int trial = 0; trial < 5000 / kSlowdown; ++trial) {
    const Coord extent = random.chance(50) ? 12 : kLatticeLimit / 2;
    const Polygon polygon = random_polygon(random, extent);
    if (const auto kernel = outline::kernel_point(polygon)) {
      ++found;
      ASSERT_TRUE(sees_every_edge(*kernel, polygon)) << text_of(polygon);
    }
  }
  EXPECT_GT(found, 1000U / kSlowdown);
}

// Stars around the middle, with radii from 0.2 up and at least four vertices per quadrant.
TEST(StarParts, AreASinglePartForStarShapedPolygons) {
  Random random{72};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    Polygon star = random_convex(random, 24, 1'000'000);
    const Vec middle{500'000, 500'000};
    if (locate(middle, star) != geometry::Location::kInside) continue;
    for (std::size_t i = 0; i < star.size(); i += 2) {  // move every other vertex towards the middle
      star[i] = {middle.x + (star[i].x - middle.x) * 2 / 3, middle.y + (star[i].y - middle.y) * 2 / 3};
    }
    const auto clean = clean_polygon(star);
    if (!clean) continue;
    EXPECT_EQ(outline::star_parts(clean->polygon).size(), 1U) << text_of(star);
  }
}

void expect_star_partition(const Polygon& polygon) {
  const auto parts = outline::star_parts(polygon);
  Wide total = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (const outline::StarPart& part : parts) {
    ASSERT_GE(part.vertices.size(), 3U);
    ASSERT_EQ(part.vertices.size(), part.origin.size());
    total += doubled_area(part.vertices);
    const std::size_t n = part.origin.size();
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(part.vertices[i], polygon[part.origin[i]]);
      ++directed[{part.origin[i], part.origin[(i + 1) % n]}];
    }
    // Thin triangles without a deep kernel are allowed as parts.
    if (n > 3 || outline::kernel_point(part.vertices)) {
      ASSERT_TRUE(sees_every_edge(part.kernel, part.vertices)) << text_of(part.vertices) << " of " << text_of(polygon);
    }
  }
  // It is a partition: the areas add up, and every side that is not an edge of the polygon is a cut with a part on
  // either side.
  ASSERT_EQ(total, doubled_area(polygon)) << text_of(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const auto& [side, count] : directed) {
    ASSERT_EQ(count, 1) << text_of(polygon);
    ASSERT_EQ(directed.contains({side.second, side.first}), (side.first + 1) % n != side.second) << text_of(polygon);
  }
}

TEST(StarParts, PartitionRandomPolygons) {
  Random random{73};
  for (int trial = 0; trial < 3000 / kSlowdown; ++trial) {
    expect_star_partition(random_polygon(random, random.chance(30) ? 10 : 1'000'000));
    if (HasFatalFailure()) return;
  }
}

TEST(StarParts, PartitionDifficultPolygons) {
  Random random{74};
  for (int trial = 0; trial < 100 / kSlowdown; ++trial) {
    expect_star_partition(random_comb(random, 20, 400, trial % 2 == 0));
    expect_star_partition(spiral(static_cast<std::size_t>(random.between(6, 40)), 2000));
    expect_star_partition(random_needle(random, kLatticeLimit / 2));
    expect_star_partition(random_simple(random, 60, 5000));
    expect_star_partition(broken_ring(random.between(40, 90), random.between(1, 9), random.between(1, 9)));
    expect_star_partition(scaled(random_polygon(random, 40), kLatticeLimit / 64));
    if (HasFatalFailure()) return;
  }
}

TEST(StarParts, AreFewForCombsAndSpirals) {
  // Each tooth of a comb needs a part of its own; the bar belongs to one of them.
  Random random{75};
  const Polygon comb = scaled(random_comb(random, 12, 240, false), 1000);
  EXPECT_LE(outline::star_parts(comb).size(), 13U);
  EXPECT_GE(outline::star_parts(comb).size(), 12U);
  // Two neighbouring arms of a spiral form an L, which is star-shaped.
  EXPECT_LE(outline::star_parts(spiral(28, 1'000'000)).size(), 28U);
  EXPECT_GE(outline::star_parts(spiral(28, 1'000'000)).size(), 14U);
}

TEST(StarParts, KeepTheirPropertiesUnderSymmetries) {
  Random random{76};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Polygon polygon = random_polygon(random, 1'000'000);
    const Symmetry s = random.symmetry();
    for (const outline::StarPart& part : outline::star_parts(polygon)) {
      const outline::StarPart image = transformed(part, s);
      ASSERT_EQ(image.vertices, transformed(part.vertices, s));
      for (std::size_t i = 0; i < image.vertices.size(); ++i) {
        ASSERT_EQ(image.vertices[i], s.apply(polygon[image.origin[i]]));
      }
      ASSERT_TRUE(!outline::kernel_point(part.vertices) || sees_every_edge(image.kernel, image.vertices));
    }
  }
}

}  // namespace
}  // namespace selvage::test
