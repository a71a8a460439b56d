#include "protocol/methods/motions/push.h"

#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

std::vector<std::pair<std::string, calls::Direction>> read_forces(json::Fields& fields, json::Mistake& mistake) {
  const Json& list = fields.array("forces");
  if (mistake) return {};
  if (list.empty() || list.size() > kMaxForces) {
    mistake.add(ErrorCode::kOutOfRange,
                std::to_string(list.size()) + " forces; 1 to " + std::to_string(kMaxForces) + " are allowed",
                fields.pointer("forces"));
  }
  std::vector<std::pair<std::string, calls::Direction>> forces;
  for (std::size_t k = 0; k < list.size() && !mistake; ++k) {
    json::Fields force{list[k], fields.pointer("forces") + "/" + std::to_string(k), mistake};
    std::string piece = force.id("piece");
    const calls::Direction direction = calls::read_direction(force, "force", mistake);
    force.finish();
    forces.emplace_back(std::move(piece), direction);
  }
  return forces;
}

Result<calls::Motion> run_forces(const std::vector<motion::compaction::Force>& forces, const calls::Effort& effort,
                                 const Marker& start, const calls::MethodContext& context) {
  auto done = context.engine.push(start, forces, settings_of(effort), context.run);
  if (!done) return done.error();
  Json figures{{"gain", formats::in_unit(done->gain, start.resolution)}};
  figures.update(calls::rounds_json(done->rounds, done->reason));
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair};
}

Result<calls::Motion> run_push(const MotionPush& wanted, const Marker& start, const calls::MethodContext& context) {
  std::vector<motion::compaction::Force> forces;
  for (std::size_t k = 0; k < wanted.forces.size(); ++k) {
    const auto& [id, force] = wanted.forces[k];
    const auto piece = calls::piece_of(start, id, "/forces/" + std::to_string(k) + "/piece");
    if (!piece) return piece.error();
    forces.push_back({*piece, force.x, force.y});
  }
  return run_forces(forces, wanted.effort, start, context);
}

Result<calls::Motion> run_gravity(const MotionGravity& wanted, const Marker& start,
                                  const calls::MethodContext& context) {
  return run_forces(motion::compaction::gravity(start, wanted.force.x, wanted.force.y), wanted.effort, start, context);
}

constexpr std::array kPushParams = together(
    std::array{
        calls::Word{"forces", "Force[]", calls::kRequired,
                    "Those on one piece add up; a piece without one moves only out of the way."},
    },
    calls::kEffortParams);
constexpr std::array kGravityParams = together(
    std::array{
        calls::Word{"force", "Direction", calls::kRequired, "On every piece."},
    },
    calls::kEffortParams);
constexpr std::array kResults = together(
    std::array{
        calls::Word{"gain", "number", calls::kRequired, "The sum over the pieces of force times the way along it."},
    },
    calls::kRoundsResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.push",
                        calls::MethodKind::kMove,
                        &calls::read_motion<decode_motion_push, run_push>,
                        {"Pieces follow forces, the length held.", kPushParams, kResults}},
    calls::MarkerMethod{"motion.gravity",
                        calls::MethodKind::kMove,
                        &calls::read_motion<decode_motion_gravity, run_gravity>,
                        {"Every piece follows one force, the length held.", kGravityParams, kResults}}};

}  // namespace

Result<MotionPush> decode_motion_push(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionPush push;
  push.call = calls::read_call(fields, mistake);
  push.forces = read_forces(fields, mistake);
  push.effort = calls::read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return push;
}

Result<MotionGravity> decode_motion_gravity(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionGravity gravity;
  gravity.call = calls::read_call(fields, mistake);
  gravity.force = calls::read_direction(fields, "force", mistake);
  gravity.effort = calls::read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return gravity;
}

std::span<const calls::MarkerMethod> pushing_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
