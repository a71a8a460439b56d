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
[[nodiscard]] std::span<const MarkerMethod> separation_methods();  // motion.separate
[[nodiscard]] std::span<const MarkerMethod> floating_methods();    // motion.float

}  // namespace selvage
