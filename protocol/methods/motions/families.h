// The methods that change a marker, by family: a file each.
#pragma once

#include <span>

#include "protocol/calls/method.h"

namespace selvage::protocol::methods::motions {

[[nodiscard]] std::span<const calls::MarkerMethod> compaction_methods();  // motion.compact
[[nodiscard]] std::span<const calls::MarkerMethod> pushing_methods();     // motion.push, motion.gravity
[[nodiscard]] std::span<const calls::MarkerMethod> bumping_methods();     // motion.bump
[[nodiscard]] std::span<const calls::MarkerMethod> placing_methods();     // motion.place
[[nodiscard]] std::span<const calls::MarkerMethod> separation_methods();  // motion.separate
[[nodiscard]] std::span<const calls::MarkerMethod> floating_methods();    // motion.float
[[nodiscard]] std::span<const calls::MarkerMethod> gap_methods();         // motion.openGap
[[nodiscard]] std::span<const calls::MarkerMethod> tilting_methods();     // motion.tilt, motion.relax
[[nodiscard]] std::span<const calls::MarkerMethod> baseline_methods();    // motion.oneAtATime, motion.velocity

}  // namespace selvage::protocol::methods::motions
