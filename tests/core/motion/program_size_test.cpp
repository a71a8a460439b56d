// How large the linear programs of motions are, and how many sums they ask for: only what the scene requires.
// The bounds lie a little above what is measured (docs/measurements-growth.md), so that neither can grow unseen.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/motion/bump.h"
#include "core/motion/compact.h"
#include "core/motion/push.h"
#include "core/motion/relax.h"
#include "core/motion/tilt.h"
#include "tests/support/garment.h"
#include "tests/support/tiled_marker.h"

namespace selvage {
namespace {

struct Work {
  int programs{};
  ProgramSize largest;
  std::set<int> columns;  // of the programs
  std::uint64_t sums{};   // asked for, in the cache or not
};

// What a motion, told its cache and its observer, made.
template <class Motion>
Work work_of(const Motion& motion) {
  Work work;
  SumCache sums;
  Observer observer;
  observer.on_program = [&](const LinearProgram& program) {
    const ProgramSize size = size_of(program);
    ++work.programs;
    work.columns.insert(size.columns);
    work.largest.columns = std::max(work.largest.columns, size.columns);
    work.largest.rows = std::max(work.largest.rows, size.rows);
    work.largest.nonzeros = std::max(work.largest.nonzeros, size.nonzeros);
  };
  motion(sums, observer);
  work.sums = sums.counts().hits + sums.counts().misses;
  return work;
}

class ProgramSizes : public ::testing::TestWithParam<std::size_t> {
 protected:
  Marker marker_{test::tiled(test::garment("jeans_02g"), GetParam())};
  double pieces_{static_cast<double>(GetParam())};
};

TEST_P(ProgramSizes, ARoundOfCompactionGrowsWithThePiecesOnly) {
  CompactionSettings settings = compaction_settings(Accuracy::kStandard);
  settings.rounds = 1;
  const Work work = work_of(
      [&](SumCache& sums, const Observer& observer) { ASSERT_TRUE(compact(marker_, settings, sums, {}, observer)); });
  EXPECT_EQ(work.largest.columns, 2 * static_cast<int>(pieces_) + 1);
  EXPECT_LT(work.largest.rows, 13 * pieces_);
  EXPECT_LT(static_cast<double>(work.largest.nonzeros), 46 * pieces_);
  EXPECT_LT(static_cast<double>(work.sums), 5 * pieces_);
}

TEST_P(ProgramSizes, TiltingHasOneMoreColumnForAPiece) {
  if (GetParam() > 120) GTEST_SKIP() << "long";
  TiltSettings settings = tilt_settings(TiltMethod::kLinearisation, Accuracy::kStandard);
  settings.rounds = 1;
  const auto columns = [&](double limit) {
    settings.limit = Angle::of_degrees(limit);
    const Work work = work_of(
        [&](SumCache& sums, const Observer& observer) { ASSERT_TRUE(tilt(marker_, settings, sums, {}, observer)); });
    return *work.columns.rbegin();
  };
  EXPECT_EQ(columns(3) - columns(0), static_cast<int>(pieces_));
}

TEST_P(ProgramSizes, OnePieceNeedsNoProgramAndFewSums) {
  for (const std::size_t piece : {std::size_t{3}, GetParam() / 2}) {
    SumCache sums;
    const Scene scene{marker_, sums};
    (void)bump(scene, static_cast<std::uint32_t>(piece), -1, 0);
    (void)relax(scene, static_cast<std::uint32_t>(piece));
    EXPECT_LT(sums.counts().hits + sums.counts().misses, 80U);
  }
}

TEST_P(ProgramSizes, AForceOnOnePieceIsOneProgramOverAll) {
  CompactionSettings settings = compaction_settings(Accuracy::kStandard);
  settings.rounds = 1;
  const Force force{PieceId{5}, 1, 0};
  const Work work = work_of([&](SumCache& sums, const Observer& observer) {
    ASSERT_TRUE(push(marker_, {&force, 1}, settings, sums, {}, observer));
  });
  EXPECT_EQ(work.largest.columns, 4 * static_cast<int>(pieces_));  // and one for each displacement's size
}

INSTANTIATE_TEST_SUITE_P(Pieces, ProgramSizes, ::testing::Values(40, 120, 440));

}  // namespace
}  // namespace selvage
