#include "server/methods/methods.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/describe/daemon_methods.h"
#include "protocol/describe/openrpc.h"
#include "protocol/edits/changes.h"
#include "server/calls/refusals.h"
#include "server/calls/version.h"
#include "server/methods/drags.h"

namespace selvage::server::methods {
namespace {

struct OwnMethod {
  std::string_view name;
  RunsOn place{};
  calls::Outcome (Methods::*run)(const Json& params, const CallTurn& turn);  // null: the drags'
};
constexpr std::array kOwnMethods{
    OwnMethod{"engine.info", RunsOn::kAtOnce, &Methods::engine_info},
    OwnMethod{"rpc.discover", RunsOn::kAtOnce, &Methods::rpc_discover},
    OwnMethod{"marker.open", RunsOn::kRead, &Methods::marker_open},
    OwnMethod{"marker.list", RunsOn::kRead, &Methods::marker_list},
    OwnMethod{"marker.get", RunsOn::kRead, &Methods::marker_get},
    OwnMethod{"marker.close", RunsOn::kRead, &Methods::marker_close},
    OwnMethod{"marker.watch", RunsOn::kAtOnce, &Methods::marker_watch},
    OwnMethod{"marker.unwatch", RunsOn::kAtOnce, &Methods::marker_unwatch},
    OwnMethod{"marker.apply", RunsOn::kStep, &Methods::marker_apply},
    OwnMethod{"marker.undo", RunsOn::kStep, &Methods::marker_undo},
    OwnMethod{"marker.redo", RunsOn::kStep, &Methods::marker_redo},
    OwnMethod{"drag.begin", RunsOn::kDrag, nullptr},
    OwnMethod{"drag.move", RunsOn::kDrag, nullptr},
    OwnMethod{"drag.end", RunsOn::kDrag, nullptr},
};
const OwnMethod* find_own_method(std::string_view name) {
  const auto* const found = std::find_if(kOwnMethods.begin(), kOwnMethods.end(),
                                         [name](const OwnMethod& method) { return method.name == name; });
  return found == kOwnMethods.end() ? nullptr : found;
}

std::string changed_message(const ReadyChange& change, const MarkerFile& before, const store::Committed& after) {
  Json params{{"markerId", change.marker_id}, {"revision", after.revision}, {"by", change.method}};
  params.update(protocol::edits::change_json(before, *after.file));
  return protocol::json::to_text(protocol::rpc::notification("marker.changed", std::move(params)));
}

}  // namespace

calls::Outcome Methods::engine_info(const Json& params, const CallTurn&) {
  if (const auto none = protocol::calls::decode_no_params(params); !none) return protocol::rpc::rpc_error(none.error());
  protocol::calls::EngineInfo info;
  info.version = calls::kVersion;
  info.workers = static_cast<int>(workers_);
  info.markers = store_.count();
  info.max_request_bytes = limits_.transport.body_bytes;
  info.cache = sums_.counts();
  for (const OwnMethod& method : kOwnMethods) info.methods.push_back(method.name);
  for (const protocol::calls::MarkerMethod& method : protocol::methods::marker_methods()) {
    if (!find_own_method(method.name)) info.methods.push_back(method.name);
  }
  Json result = protocol::calls::encode(info);
  result["limits"].update(Json{{"openMarkers", limits_.open_markers},
                               {"waitingMotions", limits_.waiting_motions},
                               {"waitingReads", limits_.waiting_reads},
                               {"waitingMoves", limits_.waiting_moves},
                               {"callMs", limits_.call.count()},
                               {"dragsPerConnection", Drags::kMostPerSession},
                               {"connections", limits_.transport.connections},
                               {"callsPerConnection", limits_.transport.calls_per_connection}});
  return result;
}

std::string openrpc_text() {
  std::vector<protocol::describe::ToldMethod> methods;
  for (const protocol::describe::NamedWords& own : protocol::describe::daemon_words())
    methods.push_back(protocol::describe::told(own.name, own.words));
  for (const protocol::calls::MarkerMethod& method : protocol::methods::marker_methods())
    methods.push_back(protocol::describe::told(method));
  return protocol::json::to_text(openrpc_document(calls::kVersion, methods));
}

calls::Outcome Methods::rpc_discover(const Json& params, const CallTurn&) {
  if (const auto none = protocol::calls::decode_no_params(params); !none) return protocol::rpc::rpc_error(none.error());
  static const store::SharedText kText = std::make_shared<const std::string>(openrpc_text());
  return kText;
}

std::optional<calls::Outcome> Methods::replay(const std::string& marker_id, const std::optional<std::string>& op_id,
                                              std::string_view method) const {
  if (!op_id) return std::nullopt;
  const auto kept = store_.answer(marker_id, *op_id);
  if (!kept) return std::nullopt;
  if (kept->method == method) return kept->result;
  return protocol::rpc::rpc_error(
      Error{ErrorCode::kOutOfRange,
            protocol::json::shortened(Json(*op_id)) + " was the opId of a call of " + kept->method, "/opId"});
}

calls::Outcome Methods::commit(ReadyChange change, const CallTurn& turn) {
  const Revision base = change.before.revision;
  const auto text = std::make_shared<const std::string>(
      protocol::json::to_text(protocol::methods::result_json(change.marker_id, base + 1, change.fields)));
  store::NextRevision next{std::move(change.after), change.origin, {}, {}};
  if (change.op_id) next.answer = store::KeptAnswer{*change.op_id, std::string{change.method}, text};
  next.tell = [&](const store::Committed& after) {
    if (!watchers_.any(change.marker_id)) return;
    watchers_.tell(change.marker_id, changed_message(change, *change.before.file, after));
  };
  if (turn.call.left().stop_requested() || !turn.call.settle()) return calls::nobody_waits();
  const store::Commit commit = store_.commit(change.marker_id, base, std::move(next));
  switch (commit.outcome) {
    case store::Commit::Outcome::kClosed: return calls::unknown_marker(change.marker_id);
    case store::Commit::Outcome::kMismatch: return calls::revision_mismatch(change.marker_id, base, commit.revision);
    case store::Commit::Outcome::kNotWritten: return calls::not_written();
    case store::Commit::Outcome::kDone: break;
  }
  return text;
}

calls::Outcome Methods::unchanged(std::string_view method, const std::string& marker_id,
                                  const std::optional<std::string>& op_id, Json result) {
  if (!op_id) return result;
  const auto text = std::make_shared<const std::string>(protocol::json::to_text(result));
  if (!store_.keep(marker_id, {*op_id, std::string{method}, text})) return calls::not_written();
  return text;
}

calls::Outcome Methods::call(std::string_view method, const Json& params, const CallTurn& turn) {
  if (const OwnMethod* own = find_own_method(method)) return (this->*own->run)(params, turn);
  return call_on_marker(*protocol::methods::find_marker_method(method), params, turn);
}

std::optional<RunsOn> runs_on(std::string_view method) {
  if (const OwnMethod* own = find_own_method(method)) return own->place;
  const protocol::calls::MarkerMethod* on_marker = protocol::methods::find_marker_method(method);
  if (!on_marker) return std::nullopt;
  switch (on_marker->kind) {
    case protocol::calls::MethodKind::kTell: return RunsOn::kRead;
    case protocol::calls::MethodKind::kStudy: return RunsOn::kStudy;
    case protocol::calls::MethodKind::kStep: return RunsOn::kStep;
    case protocol::calls::MethodKind::kMove: return RunsOn::kMotion;
  }
  return std::nullopt;
}

}  // namespace selvage::server::methods
