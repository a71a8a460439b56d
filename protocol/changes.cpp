#include "protocol/changes.h"

#include <unordered_map>

#include "core/marker/validity.h"

namespace selvage {
namespace {

constexpr std::int64_t kLargestRevision = std::int64_t{1} << 53;  // what every client's numbers hold

ChangeCall read_change(Fields& fields, Mistake& mistake) {
  ChangeCall call;
  call.marker_id = fields.text("markerId");
  if (const auto revision = fields.maybe_integer("baseRev", 1, kLargestRevision)) {
    call.base_revision = static_cast<Revision>(*revision);
  }
  call.op_id = read_op_id(fields, mistake);
  return call;
}

// True when nothing but pieces differs.
bool same_frame(const MarkerFile& before, const MarkerFile& after) {
  Marker rest = before.marker;
  rest.pieces = after.marker.pieces;
  return rest == after.marker;
}

}  // namespace

std::optional<std::string> read_op_id(Fields& fields, Mistake& mistake) {
  if (!fields.has("opId")) {
    (void)fields.maybe_any("opId");  // so that it counts as known
    return std::nullopt;
  }
  std::string id = fields.text("opId");
  if (!mistake && (id.empty() || id.size() > kLongestOpId)) {
    mistake.add(ErrorCode::kOutOfRange,
                shortened(Json(id)) + " is out of range; 1 to " + std::to_string(kLongestOpId) +
                    " characters are allowed",
                fields.pointer("opId"));
  }
  return id;
}

Result<MarkerApply> decode_marker_apply(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MarkerApply apply;
  apply.call = read_change(fields, mistake);
  apply.edits = read_edits(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return apply;
}

Result<ChangeCall> decode_change(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  ChangeCall call = read_change(fields, mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return call;
}

Json placement_json(const Marker& marker, const Piece& piece) {
  return {{"id", piece.id},
          {"shape", marker.shapes[piece.shape.value].id},
          {"at", point_json(piece.at, marker.resolution)},
          {"rotation", piece.orientation.rotation.degrees},
          {"flip", piece.orientation.flip},
          {"tilt", piece.orientation.tilt.degrees},
          {"locked", piece.locked}};
}

Json figures_json(const Marker& marker) {
  return {{"name", marker.name},
          {"pieces", marker.pieces.size()},
          {"length", to_decimal(length_of(marker), marker.resolution)},
          {"utilisation", utilisation_of(marker)},
          {"valid", is_valid(marker)}};
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

}  // namespace selvage
