// Leftward compaction: all pieces move at once so that the marker becomes as short as possible without any piece
// jumping over another [Li94 4.1.4, 4.2.1].
//
// Laws.  (1) The answer is valid, proved in integers.  (2) It is never longer than the input, except by what the repair
// of the input reports.  (3) Locked pieces stay in place to the lattice unit.  (4) The same input and settings give the
// same answer, whatever the cache holds and however many threads are used.
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
  double least_gain{};  // rounds end with the first one that gains less than this part of the width or, when a marker
                        // longer than ten widths becomes shorter, of a tenth of its length
  double trust{};    // trust radius: in the first round, pairs within this part of the width are neighbours, or closer
                     // ones where pieces are tiny (CompactionTuning); in later rounds closer ones (position_step.h)
  double gravity{};  // weight of the mean leftward motion, relative to the length
  bool sections{};   // markers of many pieces whose rounds are hard are shortened in sections (core/motion/sections)
  int hard_round{};  // rounds end with one that solves this many programs; 0: they do not
  bool sweeps{};     // single-piece moves look for ways that the programs do not have (escape.h)
  model::RegionRule region{};
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kActiveSet};
  double simplification{};    // pairs that are farther apart than this part of the width use outlines grown by up to as
                              // much (obstacles.h); 0: every piece uses its own outline
  double solver_tolerance{};  // a program may miss its optimum by this part of 1 + the gain of the round (in
                              // thousandths of the width); the next round may still gain what it missed
  CompactionTuning tuning{};
  friend bool operator==(const CompactionSettings&, const CompactionSettings&) = default;
};
[[nodiscard]] CompactionSettings compaction_settings(Accuracy accuracy);

// The trust radius of the first round, a fraction of the width: that of the settings, halved while more pairs would be
// near than the tuning allows.  Where pieces are tiny, the radius otherwise reaches hundreds of others.
[[nodiscard]] double first_trust(const scene::Scene& scene, const CompactionSettings& settings);

// The outcome of rounds towards a goal.
struct Progress {
  scene::StopReason reason{};
  int rounds{};
  int programs{};  // linear programs solved
  double gain{};   // of the goal; lattice units
  bool hard{};     // the last round solved as many programs as CompactionSettings::hard_round
  bool firm{};     // everything that the last program pressed on is a real contact (core/model/contacts/contact.h);
                   // known only with CompactionSettings::sweeps

  // Adds the outcome of later rounds: counts and gains are sums, the rest is theirs.
  Progress& operator+=(const Progress& later);
};
// Rounds of position_step until the goal stops improving: the core of every motion of many pieces at once.
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

// Small overlaps of the input are repaired first (core/motion/repair/repair.h).
// Errors: those of repair_overlaps.
[[nodiscard]] Result<Compaction> compact(const Marker& start, const CompactionSettings& settings,
                                         const scene::Run& run);

}  // namespace selvage::motion::compaction
