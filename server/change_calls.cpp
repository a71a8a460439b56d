// Calls that change a marker by hand: apply, undo and redo.
#include <utility>

#include "protocol/changes.h"
#include "protocol/codec.h"
#include "server/methods.h"
#include "server/refusals.h"

namespace selvage {

Outcome Methods::marker_apply(const Json& params, const CallTurn& turn) {
  const auto wanted = decode_marker_apply(params);
  if (!wanted) return rpc_error(wanted.error());
  const std::string& id = wanted->call.marker_id;
  if (const auto again = replay(id, wanted->call.op_id, "marker.apply")) return *again;
  const auto now = store_.current(id);
  if (!now) return unknown_marker(id);
  if (const auto& base = wanted->call.base_revision; base && *base != now->revision) {
    return revision_mismatch(id, *base, now->revision);
  }
  auto after = apply_edits(*now->file, wanted->edits);
  if (!after) return rpc_error(after.error());
  Json fields = change_json(*now->file, *after);
  if (!after->notes.empty()) fields["notes"] = encode(after->notes);
  after->notes.clear();
  if (fields["placements"].empty() && fields["removed"].empty() && !fields.contains("whole")) {
    return unchanged("marker.apply", id, wanted->call.op_id, result_json(id, now->revision, fields));
  }
  return commit({"marker.apply", id, *now, *std::move(after), Origin::kChange, wanted->call.op_id, fields}, turn);
}

Outcome Methods::way_back(std::string_view method, const Json& params, const CallTurn& turn, Way way) {
  const auto wanted = decode_change(params);
  if (!wanted) return rpc_error(wanted.error());
  const std::string& id = wanted->marker_id;
  if (const auto again = replay(id, wanted->op_id, method)) return *again;
  auto back = store_.way_back(id, way);
  if (!back) return unknown_marker(id);
  if (const auto& base = wanted->base_revision; base && *base != back->from.revision) {
    return revision_mismatch(id, *base, back->from.revision);
  }
  const bool undo = way == Way::kUndo;
  if (!back->file) {
    const std::string what = undo ? "nothing to undo" : "nothing to redo";
    return rpc_error(Error{ErrorCode::kNothingToUndo, what, ""}, RpcCode::kMotionRefused);
  }
  const Json fields = change_json(*back->from.file, *back->file);
  return commit(
      {method, id, back->from, *std::move(back->file), undo ? Origin::kUndo : Origin::kRedo, wanted->op_id, fields},
      turn);
}

Outcome Methods::marker_undo(const Json& params, const CallTurn& turn) {
  return way_back("marker.undo", params, turn, Way::kUndo);
}

Outcome Methods::marker_redo(const Json& params, const CallTurn& turn) {
  return way_back("marker.redo", params, turn, Way::kRedo);
}

}  // namespace selvage
