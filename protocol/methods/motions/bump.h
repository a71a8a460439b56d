// motion.bump: one piece slides as far as it can, all others still.
#pragma once

#include <string>

#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

// motion.bump {"piece", "direction"}
struct MotionBump {
  calls::MotionCall call;
  std::string piece;
  calls::Direction direction;
};
[[nodiscard]] Result<MotionBump> decode_motion_bump(const Json& params);

}  // namespace selvage::protocol::methods::motions
