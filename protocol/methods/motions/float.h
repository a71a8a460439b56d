// motion.float: the free space of a marker shared out among the gaps between its pieces.
#pragma once

#include "core/motion/floating/float_apart.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

inline constexpr std::string_view kFloatModeNames[] = {"largest_minimum", "given_distance", "largest_total", "uniform",
                                                       "two_step"};  // by FloatMode
inline constexpr json::Range kFloatDistances{1e-9, 1e9};             // in the marker's unit; the lattice may allow less

// motion.float {"distance", "mode"?, "edges"?, "rounds"?}
struct MotionFloat {
  calls::MotionCall call;
  double distance{};  // in the marker's unit
  motion::floating::FloatMode mode{};
  bool edges{};
  std::optional<int> rounds;
};
[[nodiscard]] Result<MotionFloat> decode_motion_float(const Json& params);

}  // namespace selvage::protocol::methods::motions
