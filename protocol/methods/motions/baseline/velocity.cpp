// motion.velocity: a piston pushes the pieces, in time steps [Li94 2].
#include "core/motion/baseline/velocity.h"

#include "protocol/methods/motions/baseline/baseline.h"

namespace selvage::protocol::methods::motions::baseline {
namespace {

Result<calls::Motion<calls::RoundsResult>> run_velocity(const BaselineParams& params, const Marker& start,
                                                        const calls::MethodContext& context) {
  motion::baseline::VelocitySettings settings;
  settings.steps = params.rounds.value_or(settings.steps);
  return motion_of(compact_by_velocities(start, settings, context.run), context);
}

}  // namespace

calls::Method velocity_method() {
  return calls::motion_method("motion.velocity", calls::MethodKind::kMotion,
                              "A baseline: a piston pushes the pieces, in time steps.", run_velocity);
}

}  // namespace selvage::protocol::methods::motions::baseline
