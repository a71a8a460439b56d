// Leftward compaction: all pieces move at once so that the marker becomes as short as it can without one leaping over
// another [Li94 4.1.4, 4.2.1].
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, but for what healing says
// it had to grow by.  (3) Locked pieces stay to the lattice unit.  (4) Same input and settings, same answer, whatever
// the cache holds and however many hands there are.
#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/lp/solver/solve.h"
#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "core/model/free_region.h"
#include "core/motion/compaction/tuning.h"
#include "core/motion/repair/motion_result.h"
#include "core/motion/step/position_step.h"
#include "core/scene/run.h"

namespace selvage::motion::compaction {

enum class Accuracy { kDraft, kStandard, kFine };

struct CompactionSettings {
  int rounds{};         // at most this many
  double least_gain{};  // the last round is the one that gains less than this part of the width or, when a marker
                        // longer than ten widths is made shorter, of a tenth of its length
  double trust{};    // neighbours are pairs within this part of the width in the first round, within less in later ones
                     // (position_step.h)
  double gravity{};  // weight of the mean leftward motion beside the length
  model::RegionRule region{};
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kReached};
  double simplification{};  // programs are made of outlines grown by up to this part of the width, where pieces are not
                            // nearer than that (obstacles.h); 0: of their own
  double solver_tolerance{};  // of 1 + what a round gains (thousandths of the width): by so much its program may miss
                              // the best; what one round misses the next may gain
  CompactionTuning tuning{};
  friend bool operator==(const CompactionSettings&, const CompactionSettings&) = default;
};
[[nodiscard]] CompactionSettings compaction_settings(Accuracy accuracy);

// What rounds towards a goal came to.
struct Progress {
  scene::StopReason reason{};
  int rounds{};
  int programs{};  // linear programs solved
  double gain{};   // of the goal, lattice units
};
// Rounds of position_step until the goal stops improving; every motion of many pieces at once ends up here.
// REQUIRES: the scene's pieces are valid.
[[nodiscard]] Progress improve(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                               const scene::Run& run);

void record(const Progress& progress, repair::MotionResult& result);

struct Compaction : repair::MotionResult {
  double utilisation_before{}, utilisation_after{};
};

// The frame of every motion that makes a marker shorter: repairs small overlaps, lets `work` move the scene's pieces,
// and sums up.
// Errors: those of repair_overlaps.
[[nodiscard]] Result<Compaction> shortened(const Marker& start, const scene::Run& run,
                                           const std::function<Progress(scene::Scene&)>& work);

// Small overlaps in the input are healed first (core/motion/heal.h).
// Errors: those of heal.
[[nodiscard]] Result<Compaction> compact(const Marker& start, const CompactionSettings& settings,
                                         const scene::Run& run);

}  // namespace selvage::motion::compaction
