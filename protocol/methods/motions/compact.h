// motion.compact: the whole marker made shorter.
#pragma once

#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

struct MotionCompact {
  calls::MotionCall call;
  calls::Effort effort;
};
[[nodiscard]] Result<MotionCompact> decode_motion_compact(const Json& params);

}  // namespace selvage::protocol::methods::motions
