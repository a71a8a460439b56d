// How large the linear programs of motions are, and how many sums they ask for: only what the scene requires.
// The bounds lie a little above what is measured (docs/measurements-growth.md), so that neither can grow unseen.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/motion/tilting/tilt.h"
#include "core/motion/tilting/tilt_step.h"
#include "tests/support/garment.h"
#include "tests/support/one_round.h"
#include "tests/support/tiled_marker.h"

namespace selvage::motion::step {
namespace {

// The most that one round may take.
struct Most {
  const char* motion;
  std::size_t pieces;
  int programs, columns, rows;
  std::size_t nonzeros;
  std::uint64_t sums;
};
constexpr std::array kMost{
    Most{"bump", 40, 0, 0, 0, 0, 6},
    Most{"bump", 120, 0, 0, 0, 0, 6},
    Most{"bump", 440, 0, 0, 0, 0, 7},
    Most{"bump", 4000, 0, 0, 0, 0, 4},
    Most{"compact", 40, 1, 81, 437, 1518, 146},
    Most{"compact", 120, 1, 241, 1463, 5257, 463},
    Most{"compact", 440, 1, 881, 5523, 19864, 1820},
    Most{"compact", 4000, 1, 8242, 50173, 180798, 16698},
    Most{"critical path", 40, 1, 81, 111, 279, 83},
    Most{"critical path", 120, 1, 241, 372, 1026, 272},
    Most{"critical path", 440, 1, 881, 1366, 3748, 1007},
    Most{"critical path", 4000, 1, 8001, 12449, 34269, 9158},
    Most{"drag, place", 40, 0, 0, 0, 0, 11},
    Most{"drag, place", 120, 0, 0, 0, 0, 11},
    Most{"drag, place", 440, 0, 0, 0, 0, 16},
    Most{"drag, place", 4000, 0, 0, 0, 0, 9},
    Most{"drag, push", 40, 1, 44, 109, 224, 47},
    Most{"drag, push", 120, 3, 20, 82, 174, 66},
    Most{"drag, push", 440, 3, 28, 116, 281, 83},
    Most{"drag, push", 4000, 1, 29, 108, 255, 51},
    Most{"float, given distance", 40, 1, 269, 428, 1483, 114},
    Most{"float, given distance", 120, 1, 841, 1346, 4833, 373},
    Most{"float, given distance", 440, 1, 3141, 5012, 18052, 1424},
    Most{"float, given distance", 4000, 1, 29509, 45430, 163750, 13029},
    Most{"float, largest minimum", 40, 1, 81, 263, 1153, 114},
    Most{"float, largest minimum", 120, 1, 241, 851, 3844, 373},
    Most{"float, largest minimum", 440, 1, 881, 3200, 14427, 1424},
    Most{"float, largest minimum", 4000, 1, 8242, 28950, 130790, 13029},
    Most{"float, largest total", 40, 1, 189, 263, 1153, 114},
    Most{"float, largest total", 120, 1, 601, 851, 3844, 373},
    Most{"float, largest total", 440, 1, 2261, 3200, 14427, 1424},
    Most{"float, largest total", 4000, 1, 21269, 28950, 130790, 13029},
    Most{"float, two steps", 40, 2, 86, 263, 1157, 224},
    Most{"float, two steps", 120, 5, 339, 851, 3844, 1830},
    Most{"float, two steps", 440, 3, 1092, 3200, 14427, 4250},
    Most{"float, two steps", 4000, 6, 11062, 28965, 130790, 78510},
    Most{"float, uniform", 40, 1, 280, 451, 1767, 114},
    Most{"float, uniform", 120, 1, 898, 1463, 5863, 373},
    Most{"float, uniform", 440, 1, 3354, 5451, 21879, 1424},
    Most{"float, uniform", 4000, 1, 31502, 49416, 198575, 13029},
    Most{"gap", 40, 1, 160, 598, 1839, 146},
    Most{"gap", 120, 3, 400, 1748, 5542, 384},
    Most{"gap", 440, 3, 1760, 7334, 23485, 1820},
    Most{"gap", 4000, 4, 16481, 66643, 213738, 16698},
    Most{"gravity", 40, 1, 160, 597, 1838, 145},
    Most{"gravity", 120, 1, 480, 1945, 6222, 462},
    Most{"gravity", 440, 1, 1760, 7333, 23485, 1819},
    Most{"gravity", 4000, 1, 16000, 66639, 213732, 16698},
    Most{"one at a time", 40, 0, 0, 0, 0, 188},
    Most{"one at a time", 120, 0, 0, 0, 0, 656},
    Most{"one at a time", 440, 0, 0, 0, 0, 3516},
    Most{"one at a time", 4000, 0, 0, 0, 0, 34193},
    Most{"place", 40, 0, 0, 0, 0, 22},
    Most{"place", 120, 0, 0, 0, 0, 15},
    Most{"place", 440, 0, 0, 0, 0, 21},
    Most{"place", 4000, 0, 0, 0, 0, 15},
    Most{"push one across", 40, 1, 160, 603, 1862, 146},
    Most{"push one across", 120, 4, 464, 1917, 6091, 461},
    Most{"push one across", 440, 3, 740, 3342, 10350, 872},
    Most{"push one across", 4000, 5, 3989, 16331, 52090, 4078},
    Most{"push one along", 40, 1, 160, 603, 1862, 146},
    Most{"push one along", 120, 4, 420, 1853, 5773, 437},
    Most{"push one along", 440, 5, 1760, 7337, 23492, 1820},
    Most{"push one along", 4000, 9, 10680, 43345, 138695, 10854},
    Most{"relax", 40, 0, 0, 0, 0, 10},
    Most{"relax", 120, 0, 0, 0, 0, 10},
    Most{"relax", 440, 0, 0, 0, 0, 12},
    Most{"relax", 4000, 0, 0, 0, 0, 8},
    Most{"repair one", 40, 1, 9, 16, 28, 8},
    Most{"repair one", 120, 2, 193, 361, 791, 160},
    Most{"repair one", 440, 1, 9, 19, 36, 14},
    Most{"repair one", 4000, 1, 13, 28, 58, 16},
    Most{"separate one", 40, 1, 11, 18, 29, 10},
    Most{"separate one", 120, 1, 11, 20, 38, 10},
    Most{"separate one", 440, 1, 16, 43, 102, 17},
    Most{"separate one", 4000, 1, 11, 10, 24, 6},
    Most{"tilt", 40, 6, 139, 445, 1616, 702},
    Most{"tilt", 120, 6, 441, 1526, 5925, 2325},
    Most{"tilt", 440, 8, 1562, 5532, 22001, 8823},
    Most{"tilt", 4000, 7, 13525, 50973, 203790, 77077},
    Most{"velocities", 40, 1, 81, 23, 46, 248},
    Most{"velocities", 120, 1, 241, 42, 83, 741},
    Most{"velocities", 440, 1, 881, 160, 320, 3068},
    Most{"velocities", 4000, 1, 8001, 1417, 2833, 28289},
};

class ProgramSizes : public ::testing::TestWithParam<std::size_t> {
 protected:
  Marker marker_{test::tiled(test::garment("jeans_06g"), GetParam())};
};

TEST_P(ProgramSizes, AreOnlyWhatTheSceneRequires) {
  for (const test::OneRound& round : test::one_round_of_each()) {
    if (std::string{round.motion}.ends_with("whole")) continue;  // measured against, no motion of ours
    const auto* const most = std::find_if(kMost.begin(), kMost.end(), [&](const Most& m) {
      return m.motion == std::string{round.motion} && m.pieces == GetParam();
    });
    ASSERT_NE(most, kMost.end()) << round.motion << " is not pinned";
    const auto [programs, largest, sums] = test::work_of(round, marker_);
    EXPECT_LE(programs, most->programs) << round.motion;
    EXPECT_LE(largest.columns, most->columns) << round.motion;
    EXPECT_LE(largest.rows, most->rows) << round.motion;
    EXPECT_LE(largest.nonzeros, most->nonzeros) << round.motion;
    EXPECT_LE(sums, most->sums) << round.motion;
  }
}

TEST_P(ProgramSizes, TiltingHasOneMoreColumnForAPiece) {
  const tilting::TiltSettings settings =
      tilt_settings(tilting::TiltMethod::kLinearisation, compaction::Accuracy::kStandard);
  const auto columns = [&](double limit) {
    Marker marker = marker_;
    for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
    SumCache sums;
    const scene::Scene scene{marker, sums};
    int asked = 0;
    scene::Observer observer;
    observer.on_program = [&](const lp::LinearProgram& program) { asked = program.columns(); };
    const tilting::TiltStepSettings step{settings.step, settings.trust, settings.compaction.solver};
    EXPECT_EQ(tilt_step(scene, leftward_goal(scene, 0), {}, step, {sums, {}, observer}).status, lp::LpStatus::kOptimal);
    return asked;
  };
  EXPECT_EQ(columns(3) - columns(0), static_cast<int>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Pieces, ProgramSizes, ::testing::Values(40, 120, 440, 4000));

}  // namespace
}  // namespace selvage::motion::step
