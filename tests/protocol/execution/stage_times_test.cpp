#include "protocol/execution/stage_times.h"

#include <gtest/gtest.h>

namespace selvage::protocol::execution {
namespace {

TEST(StageTimer, AddsUpTheTimeOfEachStage) {
  StageTimer timer{100};
  timer.enter(scene::Stage::kDecomposition, 100.5);
  timer.enter(scene::Stage::kSums, 101);
  timer.enter(scene::Stage::kRows, 104);
  timer.enter(scene::Stage::kSolve, 105);
  timer.enter(scene::Stage::kRows, 110);
  timer.enter(scene::Stage::kVerify, 112);
  const StageTimes times = timer.times(120);
  EXPECT_EQ(times.decomposition, 0.5);
  EXPECT_EQ(times.sums, 3);
  EXPECT_EQ(times.rows, 3);
  EXPECT_EQ(times.solve, 5);
  EXPECT_EQ(times.verify, 8);
  EXPECT_EQ(times.total, 20);
}

}  // namespace
}  // namespace selvage::protocol::execution
