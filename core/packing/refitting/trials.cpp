#include "core/packing/refitting/trials.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace selvage::packing::refitting {

TrialCounts run_trials(motion::repair::MotionResult& best, std::uint64_t most, std::uint64_t fruitless,
                       const Trial& trial, const OnPresent& on_present, const scene::Run& run) {
  TrialCounts counts;
  std::uint64_t in_vain = 0;
  const scene::Run alone{run.sums, run.stop};
  Marker present = best.marker;
  if (most > 0 && fruitless > 0) on_present(present);
  while (counts.trials < most && in_vain < fruitless && !run.stopped()) {
    const std::uint64_t left = std::min(most - counts.trials, fruitless - in_vain);
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(run.executor->parallelism(), left));
    std::vector<Tried> tried(count);
    run.executor->for_each(
        count, [&](std::size_t k) { tried[k] = trial(present, counts.trials + k, count == 1 ? run.quiet() : alone); });
    for (Tried& one : tried) {
      ++counts.trials;
      ++in_vain;
      counts.work += one.work;
      const Coord length = one.marker ? length_of(*one.marker) : kLatticeLimit;
      const bool accepted = length <= best.length_after;
      if (length < best.length_after) {
        in_vain = 0;
        ++counts.shortened;
        best.marker = *one.marker;
        best.length_after = length;
      }
      if (accepted) {
        present = *std::move(one.marker);
        on_present(present);
      }
      run.observer.on_round({++best.rounds, best.length_after});
      if (accepted) break;
    }
  }
  best.reason = run.stopped()          ? scene::StopReason::kCancelled
                : in_vain >= fruitless ? scene::StopReason::kConverged
                                       : scene::StopReason::kWorkLimit;
  return counts;
}

}  // namespace selvage::packing::refitting
