// motion.push: pieces follow forces, at fixed length [Li94 4.2.2].
#include <string>

#include "protocol/methods/motions/forces.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr std::size_t kMaxForces = 100'000;

struct Force {
  static constexpr std::string_view kName = "Force", kMeaning = "A force on a piece.";
  calls::Id piece;
  calls::Direction force;

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("force", self.force, "Its magnitude counts relative to other forces.");
  }
};

struct PushParams {
  calls::CommonParams call;
  std::vector<Force> forces;
  calls::Effort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("forces", self.forces,
               "Forces on the same piece are added; a piece without a force moves only out of the way.",
               {.entries = {{1, kMaxForces}}, .entries_are = "forces"});
    v.part(self.effort);
  }
};

Result<calls::Motion<PushResult>> run_push(const PushParams& params, const Marker& start,
                                           const calls::MethodContext& context) {
  const calls::PiecesById by_id{start};
  std::vector<motion::compaction::Force> forces;
  for (std::size_t k = 0; k < params.forces.size(); ++k) {
    const auto& [id, force] = params.forces[k];
    const auto piece = by_id.piece_of(id.text, "/forces/" + std::to_string(k) + "/piece");
    if (!piece) return piece.error();
    forces.push_back({*piece, force.x, force.y});
  }
  return follow_forces(forces, params.effort, start, context);
}

}  // namespace

calls::Method push_method() {
  return calls::motion_method("motion.push", calls::MethodKind::kMotion,
                              "Moves pieces along given forces, at fixed length.", run_push);
}

}  // namespace selvage::protocol::methods::motions
