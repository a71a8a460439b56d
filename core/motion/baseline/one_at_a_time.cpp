#include "core/motion/baseline/one_at_a_time.h"

namespace selvage::motion::baseline {

Result<compaction::Compaction> compact_one_at_a_time(const Marker& start, const SweepSettings& settings,
                                                     const scene::Run& run) {
  return compaction::shortened(start, run, [&](scene::Scene& scene) {
    compaction::Progress progress;
    progress.reason = piece::sweep_until_still(scene, settings, run, progress.rounds);
    return progress;
  });
}

}  // namespace selvage::motion::baseline
