#include "protocol/marker_methods.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/codec.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage {
namespace {

// What every motion comes to.
struct Motion {
  Marker marker;
  Json figures;  // the motion's own
  Healing healing;
};

// The piece of this id; `field` is the parameter that names it.
Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field) {
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (marker.pieces[i].id == id) return PieceId{i};
  }
  return Error{ErrorCode::kOutOfRange,
               shortened(Json(id)) + " is no piece of this marker; the id of one of its " +
                   std::to_string(marker.pieces.size()) + " pieces is allowed",
               field};
}

Json rounds_json(int rounds, StopReason reason) {
  return {{"rounds", rounds}, {"stop", name_of(reason)}};
}

Result<MethodAnswer> get(const MarkerGet& wanted, const MarkerFile& file, const Means&) {
  auto document = marker_document(file, wanted.format);
  if (!document) return document.error();
  return MethodAnswer{{{"format", name_of(wanted.format)}, {"marker", *std::move(document)}}, std::nullopt};
}

Result<MethodAnswer> tell_validity(const MarkerCheck&, const MarkerFile& file, const Means& means) {
  return MethodAnswer{validity_json(file.marker, means.engine.check(file.marker, means.sums)), std::nullopt};
}

Result<Motion> run_compact(const MotionCompact& wanted, const Marker& start, const Means& means) {
  auto done = means.engine.compact(start, settings_of(wanted.effort), means.sums, means.stop, means.observer);
  if (!done) return done.error();
  return Motion{std::move(done->marker), rounds_json(done->rounds, done->reason), done->healing};
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

Result<Motion> run_bump(const MotionBump& wanted, const Marker& start, const Means& means) {
  const auto piece = piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  auto done =
      means.engine.bump(start, *piece, wanted.direction.x, wanted.direction.y, means.sums, means.stop, means.observer);
  if (!done) return done.error();
  Json touching = Json::array();
  for (const std::uint32_t other : done->bump.touching) touching.push_back(start.pieces[other].id);
  Json figures{{"at", point_json(done->bump.at, start.resolution)},
               {"gain", in_unit(done->bump.gain, start.resolution)},
               {"touching", std::move(touching)},
               {"moved", done->bump.at != start.pieces[piece->value].at}};
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

// The answer to any motion.
Json motion_fields(const Marker& start, const Motion& motion, bool valid) {
  const Marker& end = motion.marker;
  Json fields{{"name", end.name},
              {"pieces", end.pieces.size()},
              {"lengthBefore", to_decimal(length_of(start), start.resolution)},
              {"lengthAfter", to_decimal(length_of(end), end.resolution)},
              {"utilisationBefore", utilisation_of(start)},
              {"utilisationAfter", utilisation_of(end)}};
  fields.update(motion.figures);
  fields.update(Json{{"valid", valid},
                     {"healed", healing_json(motion.healing, end.resolution)},
                     {"placements", changed_placements(start, end)}});
  return fields;
}

template <auto decode, auto work>
Result<MarkerCall> read_only(const Json& params) {
  auto wanted = decode(params);
  if (!wanted) return wanted.error();
  MarkerCall call;
  call.about.marker_id = wanted->marker_id;
  call.run = [wanted = *std::move(wanted)](const MarkerFile& file, const Means& means) {
    return work(wanted, file, means);
  };
  return call;
}

template <auto decode, auto work>
Result<MarkerCall> motion(const Json& params) {
  auto wanted = decode(params);
  if (!wanted) return wanted.error();
  MarkerCall call;
  call.about = wanted->call;
  call.run = [wanted = *std::move(wanted)](const MarkerFile& file, const Means& means) -> Result<MethodAnswer> {
    Result<Motion> done = work(wanted, file.marker, means);
    if (!done) return done.error();
    means.observer.on_stage(Stage::kVerify);
    const bool valid = is_valid(done->marker);
    means.observer.on_stage(Stage::kOther);
    MethodAnswer answer{motion_fields(file.marker, *done, valid), std::nullopt};
    if (wanted.call.commit && valid && !answer.fields["placements"].empty()) answer.next = std::move(done->marker);
    return answer;
  };
  return call;
}

constexpr std::array kMarkerMethods{
    MarkerMethod{"marker.get", false, &read_only<decode_marker_get, get>},
    MarkerMethod{"marker.check", false, &read_only<decode_marker_check, tell_validity>},
    MarkerMethod{"motion.compact", true, &motion<decode_motion_compact, run_compact>},
    MarkerMethod{"motion.push", true, &motion<decode_motion_push, run_push>},
    MarkerMethod{"motion.gravity", true, &motion<decode_motion_gravity, run_gravity>},
    MarkerMethod{"motion.bump", true, &motion<decode_motion_bump, run_bump>},
};

}  // namespace

std::span<const MarkerMethod> marker_methods() {
  return kMarkerMethods;
}

const MarkerMethod* find_marker_method(std::string_view name) {
  const auto* const found = std::find_if(kMarkerMethods.begin(), kMarkerMethods.end(),
                                         [name](const MarkerMethod& method) { return method.name == name; });
  return found == kMarkerMethods.end() ? nullptr : found;
}

Json result_json(const std::string& marker_id, Revision revision, const Json& fields) {
  Json result{{"markerId", marker_id}, {"revision", revision}};
  result.update(fields);
  return result;
}

void tell_times(Json& fields, const StageTimes& times, const CacheCounts& cache) {
  fields["ms"] = encode(times);
  fields["cache"] = encode(cache);
}

RpcCode code_of_run(const MarkerMethod& method, const Error& error) {
  constexpr int kFirstOfShapes = 1100;  // below it are the mistakes of parameters
  const bool refused = method.motion && static_cast<int>(error.code) >= kFirstOfShapes;
  return refused ? RpcCode::kMotionRefused : RpcCode::kInvalidParams;
}

}  // namespace selvage
