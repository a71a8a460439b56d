// The size of the linear programs of motions, and the number of sums that they request: only what the scene requires.
#include <gtest/gtest.h>

#include <string>

#include "core/motion/tilting/tilt.h"
#include "core/motion/tilting/tilt_step.h"
#include "tests/motions/motion_cases.h"
#include "tests/pins/pins.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::test {
namespace {

class ProgramSizes : public ::testing::TestWithParam<std::size_t> {
 protected:
  Marker marker_{tiled(garment("jeans_06g"), GetParam())};
};

TEST_P(ProgramSizes, AreOnlyWhatTheSceneRequires) {
  for (const OneRound& round : one_round_of_each()) {
    if (std::string{round.motion}.ends_with("whole")) continue;  // a baseline for comparison, not one of our motions
    const auto [programs, largest, sums] = work_of(round, marker_);
    const auto expect = [&](const char* figure, auto measured) {
      const std::string key = std::string{round.motion} + "/" + std::to_string(GetParam()) + "/" + figure;
      expect_pinned("program_sizes", key, static_cast<double>(measured));
    };
    expect("programs", programs);
    expect("columns", largest.columns);
    expect("rows", largest.rows);
    expect("nonzeros", largest.nonzeros);
    expect("sums", sums);
  }
}

TEST_P(ProgramSizes, TiltingHasOneMoreColumnForAPiece) {
  const motion::tilting::TiltSettings settings =
      tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
  const auto columns = [&](double limit) {
    Marker marker = marker_;
    for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
    SumCache sums;
    const scene::Scene scene{marker, sums};
    int asked = 0;
    scene::Observer observer;
    observer.on_program = [&](const lp::LinearProgram& program) { asked = program.columns(); };
    const motion::tilting::TiltStepSettings step{settings.step, settings.trust, settings.compaction.solver};
    EXPECT_EQ(
        motion::tilting::tilt_step(scene, motion::step::leftward_goal(scene, 0), {}, step, {sums, {}, observer}).status,
        lp::LpStatus::kOptimal);
    return asked;
  };
  EXPECT_EQ(columns(3) - columns(0), static_cast<int>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Pieces, ProgramSizes, ::testing::Values(40, 120, 440, 4000));

}  // namespace
}  // namespace selvage::test
