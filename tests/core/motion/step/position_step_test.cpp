// One round of any motion of many pieces at once.
#include "core/motion/step/position_step.h"

#include <gtest/gtest.h>

#include "core/marker/clearance.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::step {
namespace {

class PositionStepOfGarments : public ::testing::TestWithParam<const char*> {};

// A trust radius so small that moves violate rows that were left out.
constexpr double kTrust = 0.01;

TEST_P(PositionStepOfGarments, MovesAreShortenedWhereAProgramIsNotWorthSolvingAgain) {
  const Marker marker = test::loosened(test::garment(GetParam()), 0.05);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const Goal goal = leftward_goal(scene, 0.003);
  const PositionStep best = position_step(scene, goal, {.trust = kTrust}, {sums});
  ASSERT_EQ(best.end, StepEnd::kMoved);
  ASSERT_GT(best.programs, 1);
  const PositionStep once = position_step(scene, goal, {.trust = kTrust, .worth = 1}, {sums});
  ASSERT_EQ(once.end, StepEnd::kMoved);
  EXPECT_LT(once.programs, best.programs);
  EXPECT_GT(once.gain, 0);
  EXPECT_LE(once.gain, best.gain * (1 + 1e-6));
  marker::PlacedPieces moved = scene.pieces;
  moved.place(once.positions);
  EXPECT_TRUE(conflicts(moved).empty());
  EXPECT_LT(moved.length(), scene.pieces.length());
  // A program that gains more than that is worth solving again.
  const PositionStep again = position_step(scene, goal, {.trust = kTrust, .worth = 1e-6}, {sums});
  EXPECT_EQ(again.programs, best.programs);
  EXPECT_EQ(again.positions, best.positions);
}

// A round that may solve no more programs used to end without any move, as if the marker could not become shorter.
TEST_P(PositionStepOfGarments, TheLastProgramOfARoundMovesThePieces) {
  const Marker marker = test::loosened(test::garment(GetParam()), 0.05);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const Goal goal = leftward_goal(scene, 0.003);
  const int needed = position_step(scene, goal, {.trust = kTrust}, {sums}).programs;
  ASSERT_GT(needed, 1);
  for (int programs = 1; programs < needed; ++programs) {
    const PositionStep step = position_step(scene, goal, {.trust = kTrust, .tuning = {.programs = programs}}, {sums});
    ASSERT_EQ(step.end, StepEnd::kMoved) << programs;
    EXPECT_EQ(step.programs, programs);
    marker::PlacedPieces moved = scene.pieces;
    moved.place(step.positions);
    EXPECT_TRUE(conflicts(moved).empty());
    EXPECT_LT(moved.length(), scene.pieces.length());
  }
}

// Rows of pairs that are far apart make a program's factor dense, so a round ends with the first program that has many.
TEST_P(PositionStepOfGarments, AProgramThatHasOutgrownTheFirstIsTheLastOfItsRound) {
  const Marker marker = test::loosened(test::garment(GetParam()), 0.6);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const auto rows_of = [&](const StepTuning& tuning) {
    std::vector<int> rows;
    scene::Run run{sums};
    run.observer.on_program = [&](const lp::LinearProgram& program) { rows.push_back(program.rows()); };
    const PositionStep step = position_step(scene, leftward_goal(scene, 0.003), {.trust = 0.05, .tuning = tuning}, run);
    EXPECT_EQ(step.end, StepEnd::kMoved);
    marker::PlacedPieces moved = scene.pieces;
    moved.place(step.positions);
    EXPECT_TRUE(conflicts(moved).empty());
    return rows;
  };
  constexpr double kGrowth = 1.05;
  const std::vector<int> unlimited = rows_of({.most_growth = 1e9});
  // Right walls are rows that do not count: a piece has at most one.
  const double most = kGrowth * unlimited.front() + static_cast<double>(marker.pieces.size());
  ASSERT_GT(unlimited.back(), most);
  const std::vector<int> limited = rows_of({.most_growth = kGrowth, .spare_rows = 0});
  EXPECT_LT(limited.size(), unlimited.size());
  for (std::size_t k = 0; k + 1 < limited.size(); ++k) EXPECT_LE(limited[k], most);
}

// Where rows enter late, the program is solved again only around them.
TEST_P(PositionStepOfGarments, LocalSolutionsSaveProgramsAndKeepMostOfTheGain) {
  const Marker marker = test::loosened(test::garment(GetParam()), 0.05);
  SumCache sums;
  const scene::Scene scene{marker, sums};
  const Goal goal = leftward_goal(scene, 0.003);
  const PositionStep solved = position_step(scene, goal, {.trust = kTrust}, {sums});
  const StepTuning local{.large_marker = 0, .local_gain = 0.5};
  const PositionStep step = position_step(scene, goal, {.trust = kTrust, .tuning = local}, {sums});
  ASSERT_EQ(step.end, StepEnd::kMoved);
  EXPECT_LT(step.programs, solved.programs);
  EXPECT_GT(step.gain, 0.5 * solved.gain);
  marker::PlacedPieces moved = scene.pieces;
  moved.place(step.positions);
  EXPECT_TRUE(conflicts(moved).empty());
  EXPECT_LT(moved.length(), scene.pieces.length());
}

INSTANTIATE_TEST_SUITE_P(Garments, PositionStepOfGarments, ::testing::Values("jeans_02g", "simon_06g", "jeans_06g"),
                         test::garment_name);

}  // namespace
}  // namespace selvage::motion::step
