// Tests of core/outline/decomposition/triangulation.h: the triangles of random and difficult polygons form a partition.
#include "core/outline/decomposition/triangulation.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

void expect_triangle_partition(const Polygon& polygon) {
  const auto triangles = outline::decomposition::triangulate(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2) << text_of(polygon);
  Wide total = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (const outline::decomposition::Triangle& t : triangles) {
    const std::vector<Vec> corners{polygon[t[0]], polygon[t[1]], polygon[t[2]]};
    ASSERT_GT(doubled_area(corners), 0) << text_of(polygon);
    total += doubled_area(corners);
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  }
  // The areas add up, and every side is an edge of the polygon or a cut with a triangle on either side, so the
  // triangles are a partition.
  ASSERT_EQ(total, doubled_area(polygon)) << text_of(polygon);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const auto& [side, count] : directed) {
    ASSERT_EQ(count, 1) << text_of(polygon);
    const bool edge = (side.first + 1) % n == side.second;
    ASSERT_EQ(directed.contains({side.second, side.first}), !edge) << text_of(polygon);
  }
}

TEST(Triangulation, PartitionsRandomPolygons) {
  Random random{61};
  for (int trial = 0; trial < 3000 / kSlowdown; ++trial) {
    expect_triangle_partition(random_polygon(random, random.chance(50) ? 10 : 1'000'000));
    if (HasFatalFailure()) return;
  }
}

TEST(Triangulation, PartitionsDifficultPolygons) {
  Random random{62};
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    expect_triangle_partition(random_comb(random, 30, 300, trial % 2 == 0));
    expect_triangle_partition(spiral(static_cast<std::size_t>(random.between(9, 60)), 2000));
    expect_triangle_partition(random_needle(random, kLatticeLimit / 2));
    expect_triangle_partition(random_simple(random, 60, 40));
    expect_triangle_partition(broken_ring(random.between(40, 90), random.between(1, 9), random.between(1, 9)));
    if (HasFatalFailure()) return;
  }
}

// Vertices one unit off a straight line as long as the lattice, which doubles could not decide correctly.
TEST(Triangulation, IsExactOnNearlyFlatChains) {
  const Coord far = kLatticeLimit / 2;
  Polygon sag{{far, 3}, {-far, 3}};
  for (Coord k = -9; k <= 9; ++k) sag.push_back({k * (far / 10), k % 2 == 0 ? 0 : 1});
  const auto clean = clean_polygon(sag);
  ASSERT_TRUE(clean);
  expect_triangle_partition(clean->polygon);
}

TEST(Triangulation, PartitionsLargePolygons) {
  Random random{63};
  expect_triangle_partition(random_star(random, geometry::kMaxVertices, kLatticeLimit / 2));
  expect_triangle_partition(spiral(geometry::kMaxVertices / 2 - 1, kLatticeLimit / 4));
}

}  // namespace
}  // namespace selvage::test
