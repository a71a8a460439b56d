// The methods that edit a marker: marker.apply, marker.undo and marker.redo.
#include <utility>

#include "protocol/edits/changes.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::edits::apply_edits;
using protocol::edits::apply_result;
using protocol::edits::ApplyParams;
using protocol::edits::ApplyResult;
using protocol::edits::change_between;
using protocol::edits::ChangeParams;
using protocol::edits::CommittedChange;
using protocol::schema::encode;
using store::UndoDirection;

calls::Outcome apply(const ApplyParams& params, const ServerContext& server, calls::OpenCall& call) {
  const auto& [id, base, op_id] = params.call;
  if (const auto earlier = server.committer.earlier_answer(id, op_id, "marker.apply", call)) return *earlier;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(server.store, id);
  if (base && *base != now->revision) return calls::revision_mismatch(id, *base, now->revision);
  auto after = apply_edits(*now->file, params.edits);
  if (!after) return protocol::rpc::rpc_error(after.error());
  const ApplyResult result = apply_result(id, now->revision, *now->file, *after);
  if (result.committed.change.none()) {
    return server.committer.keep_unchanged("marker.apply", id, op_id, encode(result), call);
  }
  return server.committer.commit(
      {"marker.apply", id, *now, *std::move(after), store::Origin::kChange, op_id, encode(result)}, call);
}

template <UndoDirection direction>
calls::Outcome undo_or_redo(const ChangeParams& params, const ServerContext& server, calls::OpenCall& call) {
  constexpr bool kUndo = direction == UndoDirection::kUndo;
  constexpr std::string_view kMethod = kUndo ? "marker.undo" : "marker.redo";
  const auto& [id, base, op_id] = params;
  if (const auto earlier = server.committer.earlier_answer(id, op_id, kMethod, call)) return *earlier;
  auto next = server.store.peek(id, direction);
  if (!next) return calls::unknown_marker(server.store, id);
  if (base && *base != next->from.revision) return calls::revision_mismatch(id, *base, next->from.revision);
  if (!next->file) return protocol::calls::nothing_to_undo(kUndo);
  const CommittedChange result{{id, next->from.revision + 1}, change_between(*next->from.file, *next->file)};
  return server.committer.commit({kMethod, id, next->from, *std::move(next->file),
                                  kUndo ? store::Origin::kUndo : store::Origin::kRedo, op_id, encode(result)},
                                 call);
}

}  // namespace

std::vector<HandledMethod> change_methods() {
  return {{"marker.apply", handle_with<ApplyParams, apply>},
          {"marker.undo", handle_with<ChangeParams, undo_or_redo<UndoDirection::kUndo>>},
          {"marker.redo", handle_with<ChangeParams, undo_or_redo<UndoDirection::kRedo>>}};
}

}  // namespace selvage::server::methods
