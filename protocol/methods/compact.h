// motion.compact: the whole marker made shorter.
#pragma once

#include "protocol/methods/motion.h"

namespace selvage {

struct MotionCompact {
  MotionCall call;
  Effort effort;
};
[[nodiscard]] Result<MotionCompact> decode_motion_compact(const Json& params);

}  // namespace selvage
