// One round of leftward compaction: model, solve, snap, prove [Li94 4.1.4].
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/motion/compact.h"
#include "core/motion/scene.h"

namespace selvage {

struct LeftwardStep {
  std::optional<std::vector<Vec>> positions;  // proved valid and no longer than before; nothing: no step was found
  int programs{};                             // linear programs solved
  double farthest{};                          // the most that two near pieces moved against each other on an axis, as a
                                              // part of the strip's width
};

// The best step within `trust` (see CompactionSettings).  Pairs farther apart than that are only modelled when a solution makes
// them collide.
[[nodiscard]] LeftwardStep leftward_step(const Scene& scene, const CompactionSettings& settings, double trust,
                                         std::stop_token stop, const Observer& observer);

}  // namespace selvage
