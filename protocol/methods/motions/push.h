// motion.push and motion.gravity: pieces follow forces, the length held.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

inline constexpr std::size_t kMaxForces = 100'000;

// motion.push {"forces": [{"piece", "force"}]}
struct MotionPush {
  calls::MotionCall call;
  calls::Effort effort;
  std::vector<std::pair<std::string, calls::Direction>> forces;  // a piece's id, and the force on it
};
[[nodiscard]] Result<MotionPush> decode_motion_push(const Json& params);

// motion.gravity {"force"}
struct MotionGravity {
  calls::MotionCall call;
  calls::Effort effort;
  calls::Direction force;
};
[[nodiscard]] Result<MotionGravity> decode_motion_gravity(const Json& params);

}  // namespace selvage::protocol::methods::motions
