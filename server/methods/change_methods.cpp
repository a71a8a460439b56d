// The methods that edit a marker: marker.apply, marker.undo and marker.redo.
#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/marker_methods.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::edits::ChangeCall;
using protocol::edits::MarkerApply;
using store::UndoDirection;

calls::Outcome apply(const MarkerApply& request, const ServerContext& server, calls::OpenCall& call) {
  const auto& [id, base, op_id] = request.call;
  if (const auto earlier = server.committer.earlier_answer(id, op_id, "marker.apply")) return *earlier;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(id);
  if (base && *base != now->revision) return calls::revision_mismatch(id, *base, now->revision);
  auto after = apply_edits(*now->file, request.edits);
  if (!after) return protocol::rpc::rpc_error(after.error());
  Json fields = protocol::edits::change_json(*now->file, *after);
  if (!after->notes.empty()) fields["notes"] = protocol::calls::encode(after->notes);
  after->notes.clear();
  if (fields["placements"].empty() && fields["removed"].empty() && !fields.contains("whole")) {
    return server.committer.keep_unchanged("marker.apply", id, op_id,
                                           protocol::methods::result_json(id, now->revision, fields));
  }
  return server.committer.commit({"marker.apply", id, *now, *std::move(after), store::Origin::kChange, op_id, fields},
                                 call);
}

template <UndoDirection direction>
calls::Outcome undo_or_redo(const ChangeCall& request, const ServerContext& server, calls::OpenCall& call) {
  constexpr bool kUndo = direction == UndoDirection::kUndo;
  constexpr std::string_view kMethod = kUndo ? "marker.undo" : "marker.redo";
  const auto& [id, base, op_id] = request;
  if (const auto earlier = server.committer.earlier_answer(id, op_id, kMethod)) return *earlier;
  auto next = server.store.peek(id, direction);
  if (!next) return calls::unknown_marker(id);
  if (base && *base != next->from.revision) return calls::revision_mismatch(id, *base, next->from.revision);
  if (!next->file) {
    return rpc_error(Error{ErrorCode::kNothingToUndo, kUndo ? "nothing to undo" : "nothing to redo", ""},
                     protocol::rpc::RpcCode::kMotionRefused);
  }
  const Json fields = protocol::edits::change_json(*next->from.file, *next->file);
  return server.committer.commit({kMethod, id, next->from, *std::move(next->file),
                                  kUndo ? store::Origin::kUndo : store::Origin::kRedo, op_id, fields},
                                 call);
}

}  // namespace

std::vector<Method> change_methods() {
  using namespace protocol::edits;
  return {{"marker.apply", Schedule::kChange, decode_and_run<decode_marker_apply, apply>},
          {"marker.undo", Schedule::kChange, decode_and_run<decode_change, undo_or_redo<UndoDirection::kUndo>>},
          {"marker.redo", Schedule::kChange, decode_and_run<decode_change, undo_or_redo<UndoDirection::kRedo>>}};
}

}  // namespace selvage::server::methods
