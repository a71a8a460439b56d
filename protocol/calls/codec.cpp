#include "protocol/calls/codec.h"

#include "protocol/calls/call_fields.h"
#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/fields.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::calls {

Result<std::string> decode_marker_id(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  std::string id = fields.text("markerId");
  fields.finish();
  if (mistake) return mistake.error();
  return id;
}

Result<NoParams> decode_no_params(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  fields.finish();
  if (mistake) return mistake.error();
  return NoParams{};
}

Result<MarkerOpen> decode_marker_open(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  const Json& document = fields.object("marker");
  const auto spacing = fields.maybe_number("spacing");
  auto op_id = read_op_id(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();

  auto file = formats::read_document(document);
  if (!file) return json::within("/marker", file.error());
  for (Note& note : file->notes) note.field.insert(0, "/marker");
  if (!spacing) return MarkerOpen{*std::move(file), std::move(op_id)};
  auto spaced = formats::with_spacing(*std::move(file), *spacing);
  if (!spaced) return spaced.error();
  return MarkerOpen{*std::move(spaced), std::move(op_id)};
}

Result<MarkerClose> decode_marker_close(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MarkerClose close;
  close.marker_id = fields.text("markerId");
  close.op_id = read_op_id(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return close;
}

Json encode(const minkowski::CacheCounts& cache) {
  return {{"hits", cache.hits},
          {"misses", cache.misses},
          {"entries", cache.entries},
          {"bytes", cache.bytes},
          {"limit", cache.limit}};
}

Json encode(const execution::StageTimes& times) {
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
          {"writes", document::kFormatNames},
          {"accuracies", kAccuracyNames},
          {"workers", info.workers},
          {"markers", info.markers},
          {"limits",
           {{"requestBytes", info.max_request_bytes},
            {"batch", rpc::kMaxBatch},
            {"depth", json::kMaxDepth},
            {"values", json::most_values(info.max_request_bytes)},
            {"pieces", marker::kMaxPieces},
            {"vertices", geometry::kMaxVertices}}},
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

Json repair_json(const motion::repair::Repair& repair, Resolution resolution) {
  return {{"pairs", repair.pairs},
          {"protruding", repair.protruding},
          {"deepest", formats::in_unit(repair.deepest, resolution)},
          {"farthestMove", to_decimal(repair.farthest_move, resolution)},
          {"lengthened", to_decimal(repair.lengthened, resolution)}};
}

Json overlaps_json(const Marker& marker, const std::vector<marker::Overlap>& overlaps) {
  const auto length = [&](double lattice) { return formats::in_unit(lattice, marker.resolution); };
  const auto id_of = [&](PieceId piece) { return marker.pieces[piece.value].id; };
  Json list = Json::array();
  for (const marker::Overlap& overlap : overlaps) {
    list.push_back({{"first", id_of(overlap.first)},
                    {"second", id_of(overlap.second)},
                    {"witness", Json::array({length(overlap.witness_x), length(overlap.witness_y)})},
                    {"depth", length(overlap.depth)}});
  }
  return list;
}

Json validity_json(const Marker& marker, const marker::Validity& validity) {
  Json protrusions = Json::array();
  for (const marker::Protrusion& protrusion : validity.protrusions) {
    protrusions.push_back(
        {{"piece", marker.pieces[protrusion.piece.value].id}, {"by", to_decimal(protrusion.by, marker.resolution)}});
  }
  return {{"valid", validity.valid()},
          {"overlaps", overlaps_json(marker, validity.overlaps)},
          {"protrusions", std::move(protrusions)}};
}

Json changed_placements(const Marker& before, const Marker& after) {
  Json changed = Json::array();
  auto was = before.pieces.begin();
  for (const Piece& piece : after.pieces) {
    while (was != before.pieces.end() && was->id != piece.id) ++was;
    if (was != before.pieces.end() && piece.at == was->at && piece.orientation == was->orientation) continue;
    changed.push_back({{"id", piece.id},
                       {"at", formats::point_json(piece.at, after.resolution)},
                       {"rotation", piece.orientation.rotation.degrees},
                       {"flip", piece.orientation.flip},
                       {"tilt", piece.orientation.tilt.degrees}});
  }
  return changed;
}

}  // namespace selvage::protocol::calls
