// motion.oneAtATime: bumps every piece to the left, one after another [Li94 4.2.3].
#include "core/motion/baseline/one_at_a_time.h"

#include "protocol/methods/motions/baseline/baseline.h"

namespace selvage::protocol::methods::motions::baseline {
namespace {

Result<calls::Motion<calls::RoundsResult>> run_one_at_a_time(const BaselineParams& params, const Marker& start,
                                                             const calls::MethodContext& context) {
  motion::baseline::SweepSettings settings;
  settings.sweeps = params.rounds.value_or(settings.sweeps);
  return motion_of(motion::baseline::compact_one_at_a_time(start, settings, context.run), context);
}

}  // namespace

calls::Method one_at_a_time_method() {
  return calls::motion_method("motion.oneAtATime", calls::MethodKind::kMotion,
                              "A baseline: bumps every piece to the left, one after another.", run_one_at_a_time);
}

}  // namespace selvage::protocol::methods::motions::baseline
