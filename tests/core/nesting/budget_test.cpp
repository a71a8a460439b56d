// Tests of core/nesting/budget.h: when a search explores, when it compresses, and when it ends.
#include "core/nesting/budget.h"

#include <gtest/gtest.h>

namespace selvage::nesting {
namespace {

Budget budget(std::uint64_t moves, std::function<double()> elapsed = {}, std::stop_token stop = {}) {
  return {moves, std::move(elapsed), std::move(stop), 0.8, 100};
}

TEST(Budget, EndsAtTheLimitOfMoves) {
  EXPECT_FALSE(budget(10).over(9));
  EXPECT_TRUE(budget(10).over(10));
  EXPECT_TRUE(budget(0).over(0));
}

TEST(Budget, EndsWhenCancelledOrWhenTheTimeIsUsedUp) {
  std::stop_source stop;
  const Budget stoppable = budget(10, {}, stop.get_token());
  EXPECT_FALSE(stoppable.over(0));
  stop.request_stop();
  EXPECT_TRUE(stoppable.over(0));
  EXPECT_TRUE(budget(10, [] { return 1.0; }).over(0));
  EXPECT_FALSE(budget(10, [] { return 0.99; }).over(0));
}

TEST(Budget, AlternatesInEpochsThatDouble) {
  const Budget limited = budget(1'000'000);
  for (const std::uint64_t begin : {0, 100, 300, 700}) {
    const std::uint64_t length = begin == 0 ? 100 : begin == 100 ? 200 : begin == 300 ? 400 : 800;
    EXPECT_TRUE(limited.exploring(begin)) << begin;
    EXPECT_TRUE(limited.exploring(begin + length * 79 / 100)) << begin;
    EXPECT_FALSE(limited.exploring(begin + length * 81 / 100)) << begin;
    EXPECT_NEAR(limited.compressed(begin + length * 9 / 10), 0.5, 1e-9) << begin;
  }
}

TEST(Budget, ThePhaseDoesNotDependOnTheLimitOfMoves) {
  for (std::uint64_t moves = 0; moves < 500; moves += 7) {
    EXPECT_EQ(budget(500).exploring(moves), budget(1'000'000).exploring(moves)) << moves;
  }
}

TEST(Budget, ExploresThenCompressesWhenTimeIsLimited) {
  EXPECT_TRUE(budget(1'000'000, [] { return 0.79; }).exploring(123'456));
  EXPECT_FALSE(budget(1'000'000, [] { return 0.81; }).exploring(0));
}

}  // namespace
}  // namespace selvage::nesting
