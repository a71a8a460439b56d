#include "protocol/methods/motions/forces.h"

#include <utility>

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions {

Result<calls::Motion<PushResult>> follow_forces(const std::vector<motion::compaction::Force>& forces,
                                                const calls::Effort& effort, const Marker& start,
                                                const calls::MethodContext& context) {
  auto done = motion::compaction::push(start, forces, settings_of(effort), context.run);
  if (!done) return done.error();
  const PushResult result{formats::in_unit(done->gain, start.resolution),
                          {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<PushResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace selvage::protocol::methods::motions
