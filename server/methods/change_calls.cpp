// Calls that change a marker by hand: apply, undo and redo.
#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/edits/changes.h"
#include "server/calls/refusals.h"
#include "server/methods/methods.h"

namespace selvage::server::methods {

calls::Outcome Methods::marker_apply(const Json& params, const CallTurn& turn) {
  const auto wanted = protocol::edits::decode_marker_apply(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  const std::string& id = wanted->call.marker_id;
  if (const auto again = replay(id, wanted->call.op_id, "marker.apply")) return *again;
  const auto now = store_.current(id);
  if (!now) return calls::unknown_marker(id);
  if (const auto& base = wanted->call.base_revision; base && *base != now->revision) {
    return calls::revision_mismatch(id, *base, now->revision);
  }
  auto after = apply_edits(*now->file, wanted->edits);
  if (!after) return protocol::rpc::rpc_error(after.error());
  Json fields = protocol::edits::change_json(*now->file, *after);
  if (!after->notes.empty()) fields["notes"] = protocol::calls::encode(after->notes);
  after->notes.clear();
  if (fields["placements"].empty() && fields["removed"].empty() && !fields.contains("whole")) {
    return unchanged("marker.apply", id, wanted->call.op_id, protocol::methods::result_json(id, now->revision, fields));
  }
  return commit({"marker.apply", id, *now, *std::move(after), store::Origin::kChange, wanted->call.op_id, fields},
                turn);
}

calls::Outcome Methods::way_back(std::string_view method, const Json& params, const CallTurn& turn, store::Way way) {
  const auto wanted = protocol::edits::decode_change(params);
  if (!wanted) return protocol::rpc::rpc_error(wanted.error());
  const std::string& id = wanted->marker_id;
  if (const auto again = replay(id, wanted->op_id, method)) return *again;
  auto back = store_.way_back(id, way);
  if (!back) return calls::unknown_marker(id);
  if (const auto& base = wanted->base_revision; base && *base != back->from.revision) {
    return calls::revision_mismatch(id, *base, back->from.revision);
  }
  const bool undo = way == store::Way::kUndo;
  if (!back->file) {
    const std::string what = undo ? "nothing to undo" : "nothing to redo";
    return rpc_error(Error{ErrorCode::kNothingToUndo, what, ""}, protocol::rpc::RpcCode::kMotionRefused);
  }
  const Json fields = protocol::edits::change_json(*back->from.file, *back->file);
  return commit({method, id, back->from, *std::move(back->file), undo ? store::Origin::kUndo : store::Origin::kRedo,
                 wanted->op_id, fields},
                turn);
}

calls::Outcome Methods::marker_undo(const Json& params, const CallTurn& turn) {
  return way_back("marker.undo", params, turn, store::Way::kUndo);
}

calls::Outcome Methods::marker_redo(const Json& params, const CallTurn& turn) {
  return way_back("marker.redo", params, turn, store::Way::kRedo);
}

}  // namespace selvage::server::methods
