#include "protocol/edits/changes.h"

#include <unordered_map>

#include "core/marker/figures.h"
#include "protocol/calls/call_fields.h"
#include "protocol/formats/constraints.h"

namespace selvage::protocol::edits {
namespace {

ChangeCall read_change(json::Fields& fields, json::Mistake& mistake) {
  ChangeCall call;
  call.marker_id = fields.text("markerId");
  call.base_revision = calls::read_base_revision(fields);
  call.op_id = calls::read_op_id(fields, mistake);
  return call;
}

// True when nothing but pieces differs.
bool same_frame(const MarkerFile& before, const MarkerFile& after) {
  Marker rest = before.marker;
  rest.pieces = after.marker.pieces;
  return rest == after.marker;
}

}  // namespace

Result<MarkerApply> decode_marker_apply(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MarkerApply apply;
  apply.call = read_change(fields, mistake);
  apply.edits = read_edits(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return apply;
}

Result<ChangeCall> decode_change(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  ChangeCall call = read_change(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return call;
}

MarkerFile with_marker(const MarkerFile& file, Marker next) {
  MarkerFile after{.marker = {}, .format = file.format, .notes = {}, .attributes = {}};
  after.attributes.whole = file.attributes.whole;
  after.attributes.shapes = file.attributes.shapes;
  after.attributes.pieces.reserve(next.pieces.size());
  std::size_t old = 0;  // pieces keep their order
  for (const Piece& piece : next.pieces) {
    while (old + 1 < file.marker.pieces.size() && file.marker.pieces[old].id != piece.id) ++old;
    after.attributes.pieces.push_back(file.attributes.pieces[old++]);
  }
  after.marker = std::move(next);
  return after;
}

Json placement_json(const Marker& marker, const Piece& piece) {
  Json json{{"id", piece.id},
            {"shape", marker.shapes[piece.shape.value].id},
            {"at", formats::point_json(piece.at, marker.resolution)},
            {"rotation", piece.orientation.rotation.degrees},
            {"flip", piece.orientation.flip},
            {"tilt", piece.orientation.tilt.degrees},
            {"locked", false}};
  formats::write_constraints(json, marker, piece);
  return json;
}

Json figures_json(const Marker& marker) {
  const marker::Figures figures = figures_of(marker);
  return {{"name", marker.name},
          {"pieces", marker.pieces.size()},
          {"length", to_decimal(figures.length, marker.resolution)},
          {"utilisation", figures.utilisation},
          {"valid", figures.valid}};
}

Json change_json(const MarkerFile& before, const MarkerFile& after) {
  std::unordered_map<std::string_view, const Piece*> gone;
  for (const Piece& piece : before.marker.pieces) gone.emplace(piece.id, &piece);
  Json placements = Json::array();
  for (const Piece& piece : after.marker.pieces) {
    const auto found = gone.find(piece.id);
    if (found == gone.end() || *found->second != piece) placements.push_back(placement_json(after.marker, piece));
    if (found != gone.end()) gone.erase(found);
  }
  Json removed = Json::array();
  for (const Piece& piece : before.marker.pieces) {
    if (gone.contains(piece.id)) removed.push_back(piece.id);
  }
  Json change{{"placements", std::move(placements)}, {"removed", std::move(removed)}};
  if (!same_frame(before, after)) change["whole"] = true;
  change.update(figures_json(after.marker));
  return change;
}

}  // namespace selvage::protocol::edits
