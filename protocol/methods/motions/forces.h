// What motion.push and motion.gravity share: pieces that follow forces, at fixed length.
#pragma once

#include <vector>

#include "core/motion/compaction/push.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {

struct PushResult {
  double gain{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required(
        "gain", self.gain,
        "The sum over the pieces of force times displacement along it, with the forces scaled so that the largest "
        "coordinate is 1.");
    v.part(self.rounds);
  }
};

[[nodiscard]] Result<calls::Motion<PushResult>> follow_forces(const std::vector<motion::compaction::Force>& forces,
                                                              const calls::Effort& effort, const Marker& start,
                                                              const calls::MethodContext& context);

}  // namespace selvage::protocol::methods::motions
