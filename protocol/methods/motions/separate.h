// motion.separate: overlapping pieces parted with little motion; what cannot be parted is named.
#pragma once

#include "core/motion/separation/separate.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

inline constexpr double kMostGrowth = 10;                                      // of a marker's length
inline constexpr std::string_view kTargetNames[] = {"nearest", "kernel_ray"};  // by TargetRule

// motion.separate {"grow"?, "popOut"?, "target"?, "rounds"?, "partial"?}
struct MotionSeparate {
  calls::MotionCall call;
  motion::separation::SeparationSettings settings;
  bool partial{};  // keep what was reached when not everything can be parted
};
[[nodiscard]] Result<MotionSeparate> decode_motion_separate(const Json& params);

}  // namespace selvage::protocol::methods::motions
