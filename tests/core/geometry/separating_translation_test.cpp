// Tests of separating_translation (core/geometry/separating_translation.h), on known cases and against CGAL's Minkowski
// sums.
#include "core/geometry/separating_translation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

const Polygon kBlock{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

TEST(SeparatingTranslation, IsZeroForPiecesThatDoNotOverlap) {
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {100, 30}), 0), Vec{});
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {250, 0}), 7), Vec{});
}

TEST(SeparatingTranslation, IsTheShortestWayOutOfABlock) {
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {91, 30}), 9), (Vec{9, 0}));
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {-30, -95}), 5), (Vec{0, -5}));
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {91, 30}), 8), std::nullopt);
  EXPECT_EQ(separating_translation(placed(kBlock), placed(kBlock, {91, 30}), 0), std::nullopt);
}

TEST(SeparatingTranslation, LeavesANotchAlongItsBisector) {
  // A block pushed by (8, 6) into the corner between the two arms of an L.
  const Polygon notched{{0, 0}, {300, 0}, {300, 100}, {100, 100}, {100, 300}, {0, 300}};
  EXPECT_EQ(separating_translation(placed(notched), placed(kBlock, {92, 94}), 10), (Vec{8, 6}));
  EXPECT_EQ(separating_translation(placed(notched), placed(kBlock, {92, 94}), 9), std::nullopt);
}

TEST(SeparatingTranslation, LetsAThinPartLieInsideAnother) {
  const Polygon strap{{0, 0}, {60, 0}, {60, 4}, {0, 4}};
  EXPECT_EQ(separating_translation(placed(kBlock), placed(strap, {20, 0}), 4), (Vec{0, -4}));
  EXPECT_EQ(separating_translation(placed(kBlock), placed(strap, {20, 1}), 4), std::nullopt);
}

// The distance of a point from the boundary of a sum.
double depth_of(const ExactSum& sum, Vec at) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : sum.boundary()) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double px = static_cast<double>(at.x) - a.x;
    const double py = static_cast<double>(at.y) - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(px - t * dx, py - t * dy));
  }
  return least;
}

TEST(SeparatingTranslation, IsFoundWhereverTheExactSumLeavesRoom) {
  Random random{77};
  int separated = 0;
  int refused = 0;
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Coord factor = Coord{1} << random.between(10, 30);
    const Polygon p = scaled(random_polygon(random, 100), factor);
    const Polygon q = scaled(random_polygon(random, 100), factor);
    Polygon opposite = q;
    for (Vec& v : opposite) v = -v;
    const ExactSum sum{p, opposite, ExactSum::Method::kDecomposition};
    for (int k = 0; k < 4; ++k) {
      const Vec at = {random.between(-90 * factor, 90 * factor), random.between(-90 * factor, 90 * factor)};
      if (!interiors_meet(p, moved(q, at))) continue;
      const double depth = depth_of(sum, at);
      // Just enough room, or just too little, by a hundredth of a unit of the small polygon.
      const bool enough = random.chance(50);
      const auto distance = static_cast<Coord>(depth * (enough ? 1.01 : 0.99));
      const auto by = separating_translation(placed(p), placed(q, at), distance);
      if (enough && static_cast<double>(distance) > depth + 3) {
        ASSERT_TRUE(by) << text_of(p) << "\n" << text_of(q) << "\n" << at.x << ", " << at.y << ": " << depth;
      }
      const auto back = separating_translation(placed(q, at), placed(p), distance);
      ASSERT_EQ(back, by ? std::optional{-*by} : std::nullopt) << "whichever polygon comes first";
      ++(by ? separated : refused);
      if (!by) continue;
      ASSERT_LE(dot(*by, *by), static_cast<Wide>(distance) * distance);
      ASSERT_FALSE(interiors_meet(p, moved(q, at + *by)));
    }
  }
  EXPECT_GT(separated, 100 / kSlowdown);
  EXPECT_GT(refused, 100 / kSlowdown);  // a slot that its piece fits exactly is not part of CGAL's boundary
}

}  // namespace
}  // namespace selvage::test
