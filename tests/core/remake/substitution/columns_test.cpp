#include "core/remake/substitution/columns.h"

#include <gtest/gtest.h>

#include "core/marker/marker.h"
#include "tests/support/garment.h"

namespace selvage::remake::substitution {
namespace {

Polygon rectangle(Vec low, Vec high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Columns columns(Coord width, Coord spacing = 0) {
  return {Strip{width, {}, 0}, spacing, {.cell = 1, .slip = 2}};
}

TEST(Columns, OfPiecesThatFitHaveNoExcess) {
  Columns stack = columns(100);
  stack.set(0, rectangle({0, 0}, {50, 50}));
  stack.set(1, rectangle({0, 50}, {50, 100}));
  EXPECT_EQ(stack.excess().total, 0);
  EXPECT_TRUE(stack.excess().longest.empty());
}

TEST(Columns, ReachBeyondTheStripByTheExcessOfTheirPieces) {
  Columns stack = columns(100);
  stack.set(0, rectangle({0, 0}, {50, 55}));
  stack.set(1, rectangle({20, 50}, {70, 100}));
  stack.set(2, rectangle({200, 0}, {300, 100}));  // in another column
  const auto excess = stack.excess();
  EXPECT_EQ(excess.total, 5);
  EXPECT_EQ(excess.longest, (std::vector<std::size_t>{0, 1}));
}

TEST(Columns, CountTheSpacing) {
  Columns stack = columns(100, 4);
  stack.set(0, rectangle({0, 0}, {50, 50}));
  stack.set(1, rectangle({0, 50}, {50, 100}));
  EXPECT_EQ(stack.excess().total, 4);
}

TEST(Columns, LeaveOutPiecesThatHardlyShareSomeX) {
  Columns stack = columns(100);
  stack.set(0, rectangle({0, 0}, {50, 60}));
  stack.set(1, rectangle({49, 50}, {70, 100}));
  EXPECT_EQ(stack.excess().total, 0);
}

TEST(Columns, FollowOutlinesRatherThanBoxes) {
  Columns stack = columns(100);
  stack.set(0, {{0, 0}, {100, 0}, {0, 100}});
  stack.set(1, {{100, 0}, {100, 100}, {0, 100}});
  EXPECT_NEAR(stack.excess().total, 0, 1e-9);
}

TEST(Columns, ReplaceAPiece) {
  Columns stack = columns(100);
  stack.set(0, rectangle({0, 0}, {50, 60}));
  stack.set(1, rectangle({0, 60}, {50, 110}));
  EXPECT_EQ(stack.excess().total, 10);
  stack.set(0, rectangle({0, 0}, {50, 50}));
  EXPECT_EQ(stack.excess().total, 0);
}

// The columns of a layout without overlaps have no excess.
TEST(Columns, OfValidMarkersHaveNoExcess) {
  for (const char* name : {"jeans_02g", "charlie_04g"}) {
    const Marker marker = test::garment(name);
    const auto width = static_cast<double>(marker.strip.width);
    Columns all{marker.strip, marker.spacing, {.cell = width / 500, .slip = width / 50}};
    for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) all.set(k, placed_outline(marker, PieceId{k}));
    EXPECT_LE(all.excess().total, 0.0) << name;
  }
}

}  // namespace
}  // namespace selvage::remake::substitution
