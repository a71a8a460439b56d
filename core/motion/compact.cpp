#include "core/motion/compact.h"

#include "core/marker/validity.h"
#include "core/motion/leftward_step.h"
#include "core/motion/scene.h"

namespace selvage {

// Figures behind these choices: docs/measurements.md.
CompactionSettings compaction_settings(Accuracy accuracy) {
  switch (accuracy) {
    case Accuracy::kDraft:
      return {.rounds = 4, .least_gain = 1e-4, .trust = 0.05, .gravity = 0.003, .region = RegionRule::kGreedy,
              .solver = SolverChoice::kAutomatic};
    case Accuracy::kStandard:
      return {.rounds = 60, .least_gain = 1e-6, .trust = 0.1, .gravity = 0.003, .region = RegionRule::kGreedy,
              .solver = SolverChoice::kAutomatic};
    case Accuracy::kFine: break;
  }
  return {.rounds = 400, .least_gain = 1e-8, .trust = 0.3, .gravity = 0.003, .region = RegionRule::kGreedy,
          .solver = SolverChoice::kAutomatic};
}

Result<Compaction> compact(const Marker& start, const CompactionSettings& settings, SumCache& sums, std::stop_token stop,
                           const Observer& observer) {
  observer.on_stage(Stage::kOther);
  Scene scene{start, sums};
  Compaction best;
  best.length_before = scene.pieces.length();
  best.utilisation_before = utilisation_of(start);
  const auto healing = heal(scene, stop, observer);
  if (!healing) return healing.error();
  best.healing = *healing;
  best.reason = StopReason::kWorkLimit;
  while (best.rounds < settings.rounds) {
    const LeftwardStep step = leftward_step(scene, settings, stop, observer);
    best.programs += step.programs;
    observer.on_stage(Stage::kOther);
    if (stop.stop_requested()) {
      best.reason = StopReason::kCancelled;
      break;
    }
    if (!step.positions) {
      best.reason = StopReason::kConverged;
      break;
    }
    scene.pieces.place(*step.positions);
    ++best.rounds;
    observer.on_round({best.rounds, scene.pieces.length()});
  }
  best.marker = scene.result();
  best.length_after = scene.pieces.length();
  best.utilisation_after = utilisation_of(best.marker);
  return best;
}

}  // namespace selvage
