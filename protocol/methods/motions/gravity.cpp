// motion.gravity: every piece follows one force, at fixed length [Li94 4.2.4].
#include "protocol/methods/motions/forces.h"

namespace selvage::protocol::methods::motions {
namespace {

struct GravityParams {
  calls::CommonParams call;
  calls::Direction force;
  calls::Effort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("force", self.force, "The force on every piece.");
    v.part(self.effort);
  }
};

Result<calls::Motion<PushResult>> run_gravity(const GravityParams& params, const Marker& start,
                                              const calls::MethodContext& context) {
  return follow_forces(motion::compaction::gravity(start, params.force.x, params.force.y), params.effort, start,
                       context);
}

}  // namespace

calls::Method gravity_method() {
  return calls::motion_method("motion.gravity", calls::MethodKind::kMotion,
                              "Moves all pieces along one force, at fixed length.", run_gravity);
}

}  // namespace selvage::protocol::methods::motions
