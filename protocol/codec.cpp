#include "protocol/codec.h"

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
  get.format =
      static_cast<Format>(fields.word_or("format", static_cast<std::size_t>(get.format), kFormatNames));
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
  compact.marker_id = fields.text("markerId");
  if (const auto revision = fields.maybe_integer("baseRev", 1, kLargestRevision)) {
    compact.base_revision = static_cast<Revision>(*revision);
  }
  compact.accuracy = static_cast<Accuracy>(
      fields.word_or("accuracy", static_cast<std::size_t>(compact.accuracy), kAccuracyNames));
  if (const auto rounds = fields.maybe_integer("rounds", 0, kMaxRounds))
    compact.rounds = static_cast<int>(*rounds);
  compact.commit = fields.flag_or("commit", compact.commit);
  compact.timing = fields.flag_or("timing", compact.timing);
  fields.finish();
  if (mistake) return mistake.error();
  return compact;
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
          {"methods",
           {"engine.info", "marker.open", "marker.get", "marker.check", "marker.close", "motion.compact"}},
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

Json encode(const MarkerGot& got) {
  return {{"markerId", got.marker_id},
          {"revision", got.revision},
          {"format", name_of(got.format)},
          {"marker", got.document}};
}

Json encode(const MarkerChecked& checked) {
  Json json{{"markerId", checked.marker_id}, {"revision", checked.revision}};
  json.update(checked.validity);
  return json;
}

Json encode(const MarkerClosed& closed) {
  return {{"markerId", closed.marker_id}, {"closed", true}};
}

Json encode(const MotionCompacted& compacted) {
  const CompactionFigures& figures = compacted.figures;
  Json json{{"markerId", compacted.marker_id},
            {"revision", compacted.revision},
            {"name", figures.name},
            {"pieces", figures.pieces},
            {"lengthBefore", figures.length_before},
            {"lengthAfter", figures.length_after},
            {"utilisationBefore", figures.utilisation_before},
            {"utilisationAfter", figures.utilisation_after},
            {"rounds", figures.rounds},
            {"stop", name_of(figures.stop)},
            {"valid", figures.valid},
            {"healed",
             {{"pairs", figures.healed_pairs},
              {"protruding", figures.healed_protruding},
              {"deepest", figures.healed_deepest},
              {"farthestMove", figures.healed_farthest_move},
              {"lengthened", figures.healed_lengthened}}},
            {"placements", compacted.placements}};
  if (compacted.timing) {
    json["ms"] = encode(figures.times);
    json["cache"] = encode(figures.cache);
  }
  return json;
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
    protrusions.push_back(
        {{"piece", id_of(protrusion.piece)}, {"by", to_decimal(protrusion.by, marker.resolution)}});
  }
  return {{"valid", validity.valid()},
          {"overlaps", std::move(overlaps)},
          {"protrusions", std::move(protrusions)}};
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
