// The methods on a marker, by family: a file each.
#pragma once

#include <span>

#include "protocol/methods/method.h"

namespace selvage {

[[nodiscard]] std::span<const MarkerMethod> reading_methods();     // marker.get, marker.check
[[nodiscard]] std::span<const MarkerMethod> holding_methods();     // marker.hold
[[nodiscard]] std::span<const MarkerMethod> compaction_methods();  // motion.compact
[[nodiscard]] std::span<const MarkerMethod> pushing_methods();     // motion.push, motion.gravity
[[nodiscard]] std::span<const MarkerMethod> bumping_methods();     // motion.bump
[[nodiscard]] std::span<const MarkerMethod> placing_methods();     // motion.place
[[nodiscard]] std::span<const MarkerMethod> separation_methods();  // motion.separate
[[nodiscard]] std::span<const MarkerMethod> floating_methods();    // motion.float
[[nodiscard]] std::span<const MarkerMethod> region_methods();      // marker.regions
[[nodiscard]] std::span<const MarkerMethod> gap_methods();         // motion.openGap
[[nodiscard]] std::span<const MarkerMethod> tilting_methods();     // motion.tilt, motion.relax
[[nodiscard]] std::span<const MarkerMethod> baseline_methods();    // motion.oneAtATime, motion.velocity

}  // namespace selvage
