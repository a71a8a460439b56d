#include "core/search/swap.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::search {
namespace {

// Two squares that overlap by this much; the strip has room for both, one above the other.
DrawnSwap overlapping(Coord depth) {
  test::Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(400, 400));
  layout.put(square, {0, 0}).put(square, {0, 400 - depth});
  return {layout.marker(), 400};
}

SwapOutcome completed(const DrawnSwap& drawn) {
  SumCache sums;
  return complete_swap(drawn, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
}

TEST(Swap, SeparatesPiecesThatOverlapALittle) {
  const SwapOutcome outcome = completed(overlapping(100));
  ASSERT_TRUE(outcome.marker);
  EXPECT_TRUE(is_valid(*outcome.marker));
  EXPECT_EQ(length_of(*outcome.marker), 400);
}

TEST(Swap, SeparatesDeepOverlapsOnlyIfTheSwapSaysSo) {
  DrawnSwap drawn = overlapping(200);
  const SwapOutcome refused = completed(drawn);
  EXPECT_FALSE(refused.marker);
  EXPECT_EQ(refused.programs, 0);
  drawn.even_if_deep = true;
  const SwapOutcome separated = completed(drawn);
  ASSERT_TRUE(separated.marker);
  EXPECT_TRUE(is_valid(*separated.marker));
  EXPECT_GT(separated.programs, 0);
}

TEST(Swap, SomeSwapsAreTriedEvenIfDeep) {
  test::Layout layout{1000};
  layout.put(layout.shape_of(test::rectangle(300, 650)), {0, 0});
  layout.put(layout.shape_of(test::rectangle(300, 350)), {300, 0});
  std::mt19937 random{1};
  int drawn = 0;
  int deep = 0;
  for (int k = 0; k < 400; ++k) {
    const auto swap = draw_swap(layout.marker(), random);
    if (!swap) continue;  // to turn a piece that has one orientation only
    ++drawn;
    deep += swap->even_if_deep ? 1 : 0;
  }
  EXPECT_GT(drawn, 200);
  EXPECT_GT(deep, drawn / 16);
  EXPECT_LT(deep, drawn / 4);
}

}  // namespace
}  // namespace selvage::search
