#include "protocol/methods/push.h"

#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

std::vector<std::pair<std::string, Direction>> read_forces(Fields& fields, Mistake& mistake) {
  const Json& list = fields.array("forces");
  if (mistake) return {};
  if (list.empty() || list.size() > kMaxForces) {
    mistake.add(ErrorCode::kOutOfRange,
                std::to_string(list.size()) + " forces; 1 to " + std::to_string(kMaxForces) + " are allowed",
                fields.pointer("forces"));
  }
  std::vector<std::pair<std::string, Direction>> forces;
  for (std::size_t k = 0; k < list.size() && !mistake; ++k) {
    Fields force{list[k], fields.pointer("forces") + "/" + std::to_string(k), mistake};
    std::string piece = force.id("piece");
    const Direction direction = read_direction(force, "force", mistake);
    force.finish();
    forces.emplace_back(std::move(piece), direction);
  }
  return forces;
}

Result<Motion> run_forces(const std::vector<Force>& forces, const Effort& effort, const Marker& start,
                          const Means& means) {
  auto done = means.engine.push(start, forces, settings_of(effort), means.sums, means.stop, means.observer);
  if (!done) return done.error();
  Json figures{{"gain", in_unit(done->gain, start.resolution)}};
  figures.update(rounds_json(done->rounds, done->reason));
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

Result<Motion> run_push(const MotionPush& wanted, const Marker& start, const Means& means) {
  std::vector<Force> forces;
  for (std::size_t k = 0; k < wanted.forces.size(); ++k) {
    const auto& [id, force] = wanted.forces[k];
    const auto piece = piece_of(start, id, "/forces/" + std::to_string(k) + "/piece");
    if (!piece) return piece.error();
    forces.push_back({*piece, force.x, force.y});
  }
  return run_forces(forces, wanted.effort, start, means);
}

Result<Motion> run_gravity(const MotionGravity& wanted, const Marker& start, const Means& means) {
  return run_forces(gravity(start, wanted.force.x, wanted.force.y), wanted.effort, start, means);
}

constexpr std::array kPushParams = together(
    std::array{
        Word{"forces", "Force[]", kRequired,
             "Those on one piece add up; a piece without one moves only out of the way."},
    },
    kEffortParams);
constexpr std::array kGravityParams = together(
    std::array{
        Word{"force", "Direction", kRequired, "On every piece."},
    },
    kEffortParams);
constexpr std::array kResults = together(
    std::array{
        Word{"gain", "number", kRequired, "The sum over the pieces of force times the way along it."},
    },
    kRoundsResults);

constexpr std::array kMethods{
    MarkerMethod{"motion.push",
                 MethodKind::kMove,
                 &read_motion<decode_motion_push, run_push>,
                 {"Pieces follow forces, the length held.", kPushParams, kResults}},
    MarkerMethod{"motion.gravity",
                 MethodKind::kMove,
                 &read_motion<decode_motion_gravity, run_gravity>,
                 {"Every piece follows one force, the length held.", kGravityParams, kResults}}};

}  // namespace

Result<MotionPush> decode_motion_push(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionPush push;
  push.call = read_call(fields, mistake);
  push.forces = read_forces(fields, mistake);
  push.effort = read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return push;
}

Result<MotionGravity> decode_motion_gravity(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionGravity gravity;
  gravity.call = read_call(fields, mistake);
  gravity.force = read_direction(fields, "force", mistake);
  gravity.effort = read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return gravity;
}

std::span<const MarkerMethod> pushing_methods() {
  return kMethods;
}

}  // namespace selvage
