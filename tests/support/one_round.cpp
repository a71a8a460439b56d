#include "tests/support/one_round.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/motion/baseline/one_at_a_time.h"
#include "core/motion/baseline/velocity.h"
#include "core/motion/compaction/critical_path.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "core/motion/placing/place.h"
#include "core/motion/repair/repair.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"

namespace selvage::test {
namespace {

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

// Throws when the motion failed; otherwise a failed motion would be recorded as one that needs nothing.
template <class Answer>
void require(const Result<Answer>& answer) {
  if (!answer) throw std::runtime_error{answer.error().message};
}

PieceId middle_of(const Marker& marker) {
  return PieceId{static_cast<std::uint32_t>(marker.pieces.size() / 2)};
}
// The point to the right of the middle piece's position by `part` of the strip's width.
Vec right_of_middle(const Marker& marker, double part) {
  const Vec at = marker.pieces[middle_of(marker).value].at;
  return {at.x + std::llround(part * static_cast<double>(marker.strip.width)), at.y};
}

motion::compaction::CompactionSettings one_round(model::Extent extent) {
  motion::compaction::CompactionSettings settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  settings.rounds = 1;
  settings.extent = extent;
  return settings;
}

template <model::Extent kExtent>
void compact_once(const Marker& marker, const scene::Run& run) {
  require(compact(marker, one_round(kExtent), run));
}

// Pushes across the strip when `kAcross` is true, otherwise along it.
template <bool kAcross, model::Extent kExtent>
void push_once(const Marker& marker, const scene::Run& run) {
  const motion::compaction::Force force{middle_of(marker), kAcross ? 0.0 : 1.0, kAcross ? 1.0 : 0.0};
  require(push(marker, {&force, 1}, one_round(kExtent), run));
}

// Pulls every piece to the left at fixed length.
void pull_left_once(const Marker& marker, const scene::Run& run) {
  std::vector<motion::compaction::Force> forces;
  for (std::uint32_t piece = 0; piece < marker.pieces.size(); ++piece) forces.push_back({PieceId{piece}, -1, 0});
  require(push(marker, forces, one_round(model::Extent::kActiveSet), run));
}

template <model::Extent kExtent>
void open_once(const Marker& marker, const scene::Run& run) {
  const marker::UnoccupiedSettings regions = unoccupied_settings(marker.strip);
  const std::size_t middle = unoccupied_regions(marker, regions).size() / 2;
  require(open_gap(marker, motion::compaction::AwayFromOutline{middle}, one_round(kExtent), regions, run));
}

template <motion::floating::FloatMode kMode>
void float_once(const Marker& marker, const scene::Run& run) {
  motion::floating::FloatSettings settings = float_settings(kMode, marker.strip.width / 500);
  settings.rounds = 1;
  require(float_apart(marker, settings, run));
}

// Makes the middle piece overlap its neighbour by a hundredth of the strip's width, then separates.
void separate_once(const Marker& marker, const scene::Run& run) {
  Marker overlapping = marker;
  overlapping.pieces[middle_of(marker).value].at = right_of_middle(marker, 0.01);
  motion::separation::SeparationSettings settings;
  settings.rounds = 1;
  settings.grow = 0.02;
  require(separate(overlapping, settings, run));
}

// Bumps the middle piece to the right, then makes it overlap the piece that it met by half of the largest overlap that
// is repaired.
void repair_once(const Marker& marker, const scene::Run& run) {
  Marker overlapping = marker;
  Vec& at = overlapping.pieces[middle_of(marker).value].at;
  SumCache others;
  at = motion::piece::bump(scene::Scene{marker, others}, middle_of(marker), 1, 0).at;
  at = right_of_middle(overlapping, motion::repair::kRepairLimit / 2);
  scene::Scene scene{overlapping, run.sums};
  require(motion::repair::repair_overlaps(scene, run));
}

void tilt_once(const Marker& marker, const scene::Run& run) {
  motion::tilting::TiltSettings settings =
      tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
  settings.rounds = 1;
  settings.compaction = one_round(model::Extent::kActiveSet);
  require(tilt(marker, settings, run));
}

void bump_once(const Marker& marker, const scene::Run& run) {
  (void)motion::piece::bump(scene::Scene{marker, run.sums}, middle_of(marker), -1, 0);
}
void sweep_once(const Marker& marker, const scene::Run& run) {
  motion::baseline::SweepSettings settings;
  settings.sweeps = 1;
  require(motion::baseline::compact_one_at_a_time(marker, settings, run));
}
void step_once(const Marker& marker, const scene::Run& run) {
  motion::baseline::VelocitySettings settings;
  settings.steps = 1;
  require(compact_by_velocities(marker, settings, run));
}
void critical_path_once(const Marker& marker, const scene::Run& run) {
  require(motion::compaction::critical_path(marker, run));
}
void relax_once(const Marker& marker, const scene::Run& run) {
  (void)motion::piece::relax(scene::Scene{marker, run.sums}, middle_of(marker));
}
void place_once(const Marker& marker, const scene::Run& run) {
  require(motion::placing::repair_and_place(marker, middle_of(marker), right_of_middle(marker, 0.1), {}, run));
}
template <motion::dragging::DragMode kMode>
void drag_once(const Marker& marker, const scene::Run& run) {
  (void)drag(marker, middle_of(marker), right_of_middle(marker, 0.02), kMode, run);
}

constexpr std::array kRounds{
    OneRound{"bump", kAny, bump_once},
    OneRound{"compact", kAny, compact_once<model::Extent::kActiveSet>},
    OneRound{"compact, whole", 440, compact_once<model::Extent::kWhole>},
    OneRound{"critical path", kAny, critical_path_once},
    OneRound{"drag, place", kAny, drag_once<motion::dragging::DragMode::kPlace>},
    OneRound{"drag, push", kAny, drag_once<motion::dragging::DragMode::kPush>},
    OneRound{"float, given distance", kAny, float_once<motion::floating::FloatMode::kGivenDistance>},
    OneRound{"float, largest minimum", kAny, float_once<motion::floating::FloatMode::kLargestMinimum>},
    OneRound{"float, largest total", kAny, float_once<motion::floating::FloatMode::kLargestTotal>},
    OneRound{"float, two steps", kAny, float_once<motion::floating::FloatMode::kTwoStep>},
    OneRound{"float, uniform", kAny, float_once<motion::floating::FloatMode::kUniform>},
    OneRound{"gap", kAny, open_once<model::Extent::kActiveSet>},
    OneRound{"gap, whole", 440, open_once<model::Extent::kWhole>},
    OneRound{"gravity", kAny, pull_left_once},
    OneRound{"one at a time", kAny, sweep_once},
    OneRound{"place", kAny, place_once},
    OneRound{"push one across", kAny, push_once<true, model::Extent::kActiveSet>},
    OneRound{"push one across, whole", 440, push_once<true, model::Extent::kWhole>},
    OneRound{"push one along", kAny, push_once<false, model::Extent::kActiveSet>},
    OneRound{"push one along, whole", 440, push_once<false, model::Extent::kWhole>},
    OneRound{"relax", kAny, relax_once},
    OneRound{"repair one", kAny, repair_once},
    OneRound{"separate one", kAny, separate_once},
    OneRound{"tilt", kAny, tilt_once},
    OneRound{"velocities", kAny, step_once},
};

}  // namespace

std::span<const OneRound> one_round_of_each() {
  return kRounds;
}

Work work_of(const OneRound& round, const Marker& marker) {
  Work work;
  SumCache sums;
  scene::Run run{sums};
  run.observer.on_program = [&](const lp::LinearProgram& program) {
    const scene::ProgramSize size = scene::size_of(program);
    ++work.programs;
    work.largest.columns = std::max(work.largest.columns, size.columns);
    work.largest.rows = std::max(work.largest.rows, size.rows);
    work.largest.nonzeros = std::max(work.largest.nonzeros, size.nonzeros);
  };
  round.run(marker, run);
  work.sums = sums.counts().hits + sums.counts().misses;
  return work;
}

}  // namespace selvage::test
