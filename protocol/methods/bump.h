// motion.bump: one piece slides as far as it can, all others still.
#pragma once

#include <string>

#include "protocol/methods/motion.h"

namespace selvage {

// motion.bump {"piece", "direction"}
struct MotionBump {
  MotionCall call;
  std::string piece;
  Direction direction;
};
[[nodiscard]] Result<MotionBump> decode_motion_bump(const Json& params);

}  // namespace selvage
