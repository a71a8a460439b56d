#include "protocol/stage_times.h"

#include <gtest/gtest.h>

namespace selvage {
namespace {

TEST(StageTimer, AddsUpWhatEachStageTook) {
  StageTimer timer{100};
  timer.enter(Stage::kSums, 101);
  timer.enter(Stage::kRows, 104);
  timer.enter(Stage::kSolve, 105);
  timer.enter(Stage::kRows, 110);
  timer.enter(Stage::kVerify, 112);
  const StageTimes times = timer.times(120);
  EXPECT_EQ(times.sums, 3);
  EXPECT_EQ(times.rows, 3);
  EXPECT_EQ(times.solve, 5);
  EXPECT_EQ(times.verify, 8);
  EXPECT_EQ(times.total, 20);
}

}  // namespace
}  // namespace selvage
