// Tests of core/outline/outline.h: the hash of polygons, and the properties computed for an outline.
#include "core/outline/outline.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

TEST(OutlineHash, IsTheSameOnEveryPlatform) {
  // FNV-1a of no bytes, and of the 48 bytes of two triangles, computed by another program.
  EXPECT_EQ(outline::hash_of({}), 0xcbf29ce484222325U);
  EXPECT_EQ(outline::hash_of({{0, 0}, {4, 0}, {0, 3}}), 0xaa358fc89bef1f02U);
  EXPECT_EQ(outline::hash_of({{-1, 0}, {4, -7}, {0, 3}}), 0xccdd65cc011af6b4U);
}

TEST(OutlineHash, DiffersBetweenPolygons) {
  Random random{31};
  std::set<Polygon> polygons;
  std::set<std::uint64_t> hashes;
  for (int trial = 0; trial < 5000 / kSlowdown; ++trial) {
    const Polygon polygon = random_simple(random, 8, 12);
    polygons.insert(polygon);
    hashes.insert(outline::hash_of(polygon));
    hashes.insert(outline::hash_of(moved(polygon, {1000, 0})));
  }
  EXPECT_EQ(hashes.size(), 2 * polygons.size());
  EXPECT_NE(outline::hash_of({{0, 0}, {4, 0}, {0, 4}}),
            outline::hash_of({{4, 0}, {0, 4}, {0, 0}}));  // a different first vertex
  EXPECT_NE(outline::hash_of({{1, 2}, {4, 0}, {9, 9}}), outline::hash_of({{2, 1}, {4, 0}, {9, 9}}));
}

TEST(Outline, HasTheComputedProperties) {
  Random random{32};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Polygon polygon = random_polygon(random, 1000);
    const auto outline = outline::make_outline(polygon);
    EXPECT_EQ(outline->polygon, polygon);
    EXPECT_EQ(outline->box, box_of(polygon));
    EXPECT_EQ(outline->convex, is_convex(polygon));
    EXPECT_EQ(outline->hash, outline::hash_of(polygon));
    EXPECT_FALSE(outline->parts.empty());
    EXPECT_TRUE(!outline->convex || outline->parts.size() == 1) << text_of(polygon);
  }
}

}  // namespace
}  // namespace selvage::test
