#include "core/matching/silhouette.h"

#include <gtest/gtest.h>

#include "core/matching/alignment.h"
#include "tests/support/polygons.h"

namespace selvage::matching {
namespace {

const Polygon kLargeSquare{{0, 0}, {3200, 0}, {3200, 3200}, {0, 3200}};

TEST(Silhouette, OfASquareIsFull) {
  const Silhouette square = silhouette_of(kLargeSquare);
  for (const std::uint32_t row : square.rows) EXPECT_EQ(row, 0xffffffffU);
  EXPECT_EQ(square.area, 3200.0 * 3200.0);
}

TEST(Silhouette, OfATriangleIsHalfFull) {
  const Silhouette triangle = silhouette_of({{0, 0}, {3200, 0}, {0, 3200}});
  EXPECT_EQ(triangle.rows[0] & 1U, 1U);
  EXPECT_EQ(triangle.rows[31] >> 1, 0U);
  EXPECT_EQ(triangle.rows[16] >> 16, 0U);
}

TEST(Silhouette, DifferenceIsSymmetricAndZeroForTranslatesOnly) {
  test::Random random{4};
  for (int trial = 0; trial < 200; ++trial) {
    const Polygon outline = test::random_polygon(random, 10'000);
    const Polygon other = test::random_polygon(random, 10'000);
    const Silhouette first = silhouette_of(outline);
    const Silhouette second = silhouette_of(other);
    EXPECT_EQ(estimated_difference(first, second), estimated_difference(second, first));
    EXPECT_EQ(estimated_difference(first, silhouette_of(geometry::moved(outline, {-77, 12'345}))), 0);
    if (silhouette_of(geometry::moved(other, box_of(outline).low - box_of(other).low)).hash != first.hash) {
      EXPECT_GT(estimated_difference(first, second), 0);
    }
  }
}

TEST(Silhouette, EstimatesTheDifferenceOfScaledShapes) {
  test::Random random{5};
  for (int trial = 0; trial < 50; ++trial) {
    const Polygon outline = test::random_star(random, 20, 1'000'000);
    Polygon larger = outline;
    for (Vec& v : larger) v = {v.x + v.x / 10, v.y + v.y / 10};
    const double estimated = estimated_difference(silhouette_of(outline), silhouette_of(larger));
    const double exact = best_alignment(outline, larger).difference;
    EXPECT_GT(estimated, 0.5 * exact);
    EXPECT_LT(estimated, 2.5 * exact);
  }
}

}  // namespace
}  // namespace selvage::matching
