#include "core/model/pair_rows.h"

#include <gtest/gtest.h>

#include "tests/core/motion/markers.h"

namespace selvage::model {
namespace {

const ModelUnit kUnit = ModelUnit::of(1);

TEST(RowOf, AxisRowsRequireTheirExactSlack) {
  const HalfPlane right_of{{100, 0}, {0, 50}};  // to the right of x = 100
  const PairRow row = row_of({0, 1}, side_at(right_of, {130, 7}, 0), kUnit, TightRows::kRestore);
  EXPECT_EQ(row.nx, 1);
  EXPECT_EQ(row.ny, 0);
  EXPECT_EQ(row.bound, -30);
  EXPECT_EQ(row_of({0, 1}, side_at(right_of, {130, 7}, 12), kUnit, TightRows::kRestore).bound, -18);
}

TEST(RowOf, SlantedRowsKeepAMarginForRounding) {
  const HalfPlane slanted{{0, 0}, {-30, 40}};  // right of the line: n = (0.8, 0.6)
  const PairRow roomy = row_of({0, 1}, side_at(slanted, {80, 60}, 0), kUnit, TightRows::kRestore);
  EXPECT_NEAR(roomy.bound, -(100 - 1.4), 1e-6);
  EXPECT_NEAR(row_of({0, 1}, side_at(slanted, {0, 0}, 0), kUnit, TightRows::kRestore).bound, 1.4, 1e-6);
  EXPECT_EQ(row_of({0, 1}, side_at(slanted, {0, 0}, 0), kUnit, TightRows::kKeep).bound, 0);
  EXPECT_NEAR(row_of({0, 1}, side_at(slanted, {-8, -6}, 0), kUnit, TightRows::kKeep).bound, 11.4, 1e-6);
}

TEST(PairRows, OmitRowsThatASmallMotionCannotViolate) {
  SumCache sums;
  const auto square = sums.outline(test::rectangle(100, 100));
  const minkowski::Obstacle obstacle = sums.obstacle({square, {}}, {square, {}});
  const Vec r{130, 40};  // 30 units of room to the right of the first
  const auto rows_within = [&](double motion) {
    return pair_rows({0, 1}, {obstacle, r, r, 10}, region_within(1000, 10), {kUnit, TightRows::kRestore, motion});
  };
  ASSERT_EQ(rows_within(20).size(), 1U);
  EXPECT_EQ(rows_within(20)[0].nx, 1);
  EXPECT_EQ(rows_within(20)[0].bound, -20);  // 30 less the spacing
  EXPECT_TRUE(rows_within(19).empty());
}

}  // namespace
}  // namespace selvage::model
