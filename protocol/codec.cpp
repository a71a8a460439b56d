#include "protocol/codec.h"

#include <algorithm>
#include <cmath>

#include "protocol/fields.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json_rpc.h"

namespace selvage {
namespace {

constexpr std::int64_t kLargestRevision = std::int64_t{1} << 53;  // what every client's numbers hold

// The id alone, for the methods that take nothing else.
Result<std::string> decode_marker_id(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  std::string id = fields.text("markerId");
  fields.finish();
  if (mistake) return mistake.error();
  return id;
}

MotionCall read_call(Fields& fields) {
  MotionCall call;
  call.marker_id = fields.text("markerId");
  if (const auto revision = fields.maybe_integer("baseRev", 1, kLargestRevision)) {
    call.base_revision = static_cast<Revision>(*revision);
  }
  call.commit = fields.flag_or("commit", call.commit);
  call.timing = fields.flag_or("timing", call.timing);
  return call;
}

Effort read_effort(Fields& fields) {
  Effort effort;
  effort.accuracy =
      static_cast<Accuracy>(fields.word_or("accuracy", static_cast<std::size_t>(effort.accuracy), kAccuracyNames));
  if (const auto rounds = fields.maybe_integer("rounds", 0, kMaxRounds)) effort.rounds = static_cast<int>(*rounds);
  return effort;
}

Direction read_direction(Fields& fields, std::string_view key, Mistake& mistake) {
  const std::string at = fields.pointer(key);
  const Json& value = fields.array(key);
  if (mistake) return {};
  if (value.size() != 2) {
    mistake.add(ErrorCode::kWrongType, shortened(value) + " where [x, y] is required", at);
    return {};
  }
  constexpr Range kAllowed{-kLargestForce, kLargestForce};
  const Direction read{checked_number(value[0], kAllowed, mistake, at + "/0"),
                       checked_number(value[1], kAllowed, mistake, at + "/1")};
  if (std::max(std::abs(read.x), std::abs(read.y)) < kLeastForce) {
    mistake.add(ErrorCode::kOutOfRange,
                shortened(value) + " leads nowhere; [x, y] with x or y of at least " + number_text(kLeastForce) +
                    " either way is allowed",
                at);
  }
  return read;
}

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

}  // namespace

Result<NoParams> decode_no_params(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  fields.finish();
  if (mistake) return mistake.error();
  return NoParams{};
}

Result<MarkerOpen> decode_marker_open(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  const Json& document = fields.object("marker");
  const auto spacing = fields.maybe_number("spacing");
  fields.finish();
  if (mistake) return mistake.error();

  auto file = read_document(document);
  if (!file) return within("/marker", file.error());
  for (Note& note : file->notes) note.field.insert(0, "/marker");
  if (!spacing) return MarkerOpen{*std::move(file)};
  auto spaced = with_spacing(*std::move(file), *spacing);
  if (!spaced) return spaced.error();
  return MarkerOpen{*std::move(spaced)};
}

Result<MarkerGet> decode_marker_get(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MarkerGet get;
  get.marker_id = fields.text("markerId");
  get.format = static_cast<Format>(fields.word_or("format", static_cast<std::size_t>(get.format), kFormatNames));
  fields.finish();
  if (mistake) return mistake.error();
  return get;
}

Result<MarkerCheck> decode_marker_check(const Json& params) {
  auto id = decode_marker_id(params);
  if (!id) return id.error();
  return MarkerCheck{*std::move(id)};
}

Result<MarkerClose> decode_marker_close(const Json& params) {
  auto id = decode_marker_id(params);
  if (!id) return id.error();
  return MarkerClose{*std::move(id)};
}

Result<MotionCompact> decode_motion_compact(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionCompact compact;
  compact.call = read_call(fields);
  compact.effort = read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return compact;
}

Result<MotionPush> decode_motion_push(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionPush push;
  push.call = read_call(fields);
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
  gravity.call = read_call(fields);
  gravity.force = read_direction(fields, "force", mistake);
  gravity.effort = read_effort(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return gravity;
}

Result<MotionBump> decode_motion_bump(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionBump bump;
  bump.call = read_call(fields);
  bump.piece = fields.id("piece");
  bump.direction = read_direction(fields, "direction", mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return bump;
}

Json encode(const CacheCounts& cache) {
  return {{"hits", cache.hits},
          {"misses", cache.misses},
          {"entries", cache.entries},
          {"bytes", cache.bytes},
          {"limit", cache.limit}};
}

Json encode(const StageTimes& times) {
  return {{"sums", times.sums},
          {"rows", times.rows},
          {"solve", times.solve},
          {"verify", times.verify},
          {"total", times.total}};
}

Json encode(const std::vector<Note>& notes) {
  Json list = Json::array();
  for (const Note& note : notes) list.push_back({{"field", note.field}, {"text", note.text}});
  return list;
}

Json encode(const EngineInfo& info) {
  return {{"name", "selvage"},
          {"version", info.version},
          {"methods", info.methods},
          {"reads", {"native", "sparrow"}},
          {"writes", kFormatNames},
          {"accuracies", kAccuracyNames},
          {"workers", info.workers},
          {"markers", info.markers},
          {"limits",
           {{"requestBytes", info.max_request_bytes},
            {"batch", kMaxBatch},
            {"depth", kMaxDepth},
            {"pieces", kMaxPieces},
            {"vertices", kMaxVertices}}},
          {"cache", encode(info.cache)}};
}

Json encode(const MarkerOpened& opened) {
  return {{"markerId", opened.marker_id}, {"revision", opened.revision},       {"pieces", opened.pieces},
          {"length", opened.length},      {"utilisation", opened.utilisation}, {"valid", opened.valid},
          {"notes", encode(opened.notes)}};
}

Json encode(const MarkerClosed& closed) {
  return {{"markerId", closed.marker_id}, {"closed", true}};
}

Json healing_json(const Healing& healing, Resolution resolution) {
  return {{"pairs", healing.pairs},
          {"protruding", healing.protruding},
          {"deepest", in_unit(healing.deepest, resolution)},
          {"farthestMove", to_decimal(healing.farthest_move, resolution)},
          {"lengthened", to_decimal(healing.lengthened, resolution)}};
}

Json validity_json(const Marker& marker, const Validity& validity) {
  const auto length = [&](double lattice) { return in_unit(lattice, marker.resolution); };
  const auto id_of = [&](PieceId piece) { return marker.pieces[piece.value].id; };
  Json overlaps = Json::array();
  for (const Overlap& overlap : validity.overlaps) {
    overlaps.push_back({{"first", id_of(overlap.first)},
                        {"second", id_of(overlap.second)},
                        {"witness", Json::array({length(overlap.witness_x), length(overlap.witness_y)})},
                        {"depth", length(overlap.depth)}});
  }
  Json protrusions = Json::array();
  for (const Protrusion& protrusion : validity.protrusions) {
    protrusions.push_back({{"piece", id_of(protrusion.piece)}, {"by", to_decimal(protrusion.by, marker.resolution)}});
  }
  return {{"valid", validity.valid()}, {"overlaps", std::move(overlaps)}, {"protrusions", std::move(protrusions)}};
}

Json changed_placements(const Marker& before, const Marker& after) {
  Json changed = Json::array();
  for (std::size_t i = 0; i < after.pieces.size(); ++i) {
    const Piece& piece = after.pieces[i];
    if (piece.at == before.pieces[i].at && piece.orientation == before.pieces[i].orientation) continue;
    changed.push_back({{"id", piece.id},
                       {"at", point_json(piece.at, after.resolution)},
                       {"rotation", piece.orientation.rotation.degrees},
                       {"flip", piece.orientation.flip},
                       {"tilt", piece.orientation.tilt.degrees}});
  }
  return changed;
}

}  // namespace selvage
