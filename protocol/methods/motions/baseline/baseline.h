// What the two baselines share.  Compaction is compared with them.
#pragma once

#include <optional>

#include "core/motion/compaction/compact.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions::baseline {

struct BaselineParams {
  calls::CommonParams call;
  std::optional<int> rounds;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("rounds", self.rounds, calls::Effort::kRoundsMeaning, calls::kRoundLimits);
  }
};

[[nodiscard]] inline Result<calls::Motion<calls::RoundsResult>> motion_of(Result<motion::compaction::Compaction> done,
                                                                          const calls::MethodContext& context) {
  if (!done) return done.error();
  return calls::Motion<calls::RoundsResult>{{std::move(done->marker), done->repair},
                                            {done->rounds, stop_cause(done->reason, context)}};
}

}  // namespace selvage::protocol::methods::motions::baseline
