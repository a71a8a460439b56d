#include "server/methods.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/changes.h"
#include "protocol/codec.h"
#include "protocol/daemon_words.h"
#include "protocol/openrpc.h"
#include "server/drags.h"
#include "server/refusals.h"
#include "server/version.h"

namespace selvage {
namespace {

struct OwnMethod {
  std::string_view name;
  Place place{};
  Outcome (Methods::*run)(const Json& params, const CallTurn& turn);  // null: the drags'
};
constexpr std::array kOwnMethods{
    OwnMethod{"engine.info", Place::kAtOnce, &Methods::engine_info},
    OwnMethod{"rpc.discover", Place::kAtOnce, &Methods::rpc_discover},
    OwnMethod{"marker.open", Place::kRead, &Methods::marker_open},
    OwnMethod{"marker.list", Place::kRead, &Methods::marker_list},
    OwnMethod{"marker.get", Place::kRead, &Methods::marker_get},
    OwnMethod{"marker.close", Place::kRead, &Methods::marker_close},
    OwnMethod{"marker.watch", Place::kAtOnce, &Methods::marker_watch},
    OwnMethod{"marker.unwatch", Place::kAtOnce, &Methods::marker_unwatch},
    OwnMethod{"marker.apply", Place::kStep, &Methods::marker_apply},
    OwnMethod{"marker.undo", Place::kStep, &Methods::marker_undo},
    OwnMethod{"marker.redo", Place::kStep, &Methods::marker_redo},
    OwnMethod{"drag.begin", Place::kDrag, nullptr},
    OwnMethod{"drag.move", Place::kDrag, nullptr},
    OwnMethod{"drag.end", Place::kDrag, nullptr},
};
const OwnMethod* find_own_method(std::string_view name) {
  const auto* const found = std::find_if(kOwnMethods.begin(), kOwnMethods.end(),
                                         [name](const OwnMethod& method) { return method.name == name; });
  return found == kOwnMethods.end() ? nullptr : found;
}

std::string changed_message(const ReadyChange& change, const MarkerFile& before, const Committed& after) {
  Json params{{"markerId", change.marker_id}, {"revision", after.revision}, {"by", change.method}};
  params.update(change_json(before, *after.file));
  return to_text(notification("marker.changed", std::move(params)));
}

}  // namespace

Outcome Methods::engine_info(const Json& params, const CallTurn&) {
  if (const auto none = decode_no_params(params); !none) return rpc_error(none.error());
  EngineInfo info;
  info.version = kVersion;
  info.workers = static_cast<int>(workers_);
  info.markers = store_.count();
  info.max_request_bytes = limits_.transport.body_bytes;
  info.cache = sums_.counts();
  for (const OwnMethod& method : kOwnMethods) info.methods.push_back(method.name);
  for (const MarkerMethod& method : marker_methods()) {
    if (!find_own_method(method.name)) info.methods.push_back(method.name);
  }
  Json result = encode(info);
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
  std::vector<ToldMethod> methods;
  for (const NamedWords& own : daemon_words()) methods.push_back(told(own.name, own.words));
  for (const MarkerMethod& method : marker_methods()) methods.push_back(told(method));
  return to_text(openrpc_document(kVersion, methods));
}

Outcome Methods::rpc_discover(const Json& params, const CallTurn&) {
  if (const auto none = decode_no_params(params); !none) return rpc_error(none.error());
  static const SharedText kText = std::make_shared<const std::string>(openrpc_text());
  return kText;
}

std::optional<Outcome> Methods::replay(const std::string& marker_id, const std::optional<std::string>& op_id,
                                       std::string_view method) const {
  if (!op_id) return std::nullopt;
  const auto kept = store_.answer(marker_id, *op_id);
  if (!kept) return std::nullopt;
  if (kept->method == method) return kept->result;
  return rpc_error(
      Error{ErrorCode::kOutOfRange, shortened(Json(*op_id)) + " was the opId of a call of " + kept->method, "/opId"});
}

Outcome Methods::commit(ReadyChange change, const CallTurn& turn) {
  const Revision base = change.before.revision;
  const auto text =
      std::make_shared<const std::string>(to_text(result_json(change.marker_id, base + 1, change.fields)));
  NextRevision next{std::move(change.after), change.origin, {}, {}};
  if (change.op_id) next.answer = KeptAnswer{*change.op_id, std::string{change.method}, text};
  next.tell = [&](const Committed& after) {
    if (!watchers_.any(change.marker_id)) return;
    watchers_.tell(change.marker_id, changed_message(change, *change.before.file, after));
  };
  if (turn.call.left().stop_requested() || !turn.call.settle()) return nobody_waits();
  const Commit commit = store_.commit(change.marker_id, base, std::move(next));
  switch (commit.outcome) {
    case Commit::Outcome::kClosed: return unknown_marker(change.marker_id);
    case Commit::Outcome::kMismatch: return revision_mismatch(change.marker_id, base, commit.revision);
    case Commit::Outcome::kNotWritten: return not_written();
    case Commit::Outcome::kDone: break;
  }
  return text;
}

Outcome Methods::unchanged(std::string_view method, const std::string& marker_id,
                           const std::optional<std::string>& op_id, Json result) {
  if (!op_id) return result;
  const auto text = std::make_shared<const std::string>(to_text(result));
  if (!store_.keep(marker_id, {*op_id, std::string{method}, text})) return not_written();
  return text;
}

Outcome Methods::call(std::string_view method, const Json& params, const CallTurn& turn) {
  if (const OwnMethod* own = find_own_method(method)) return (this->*own->run)(params, turn);
  return call_on_marker(*find_marker_method(method), params, turn);
}

std::optional<Place> place_of(std::string_view method) {
  if (const OwnMethod* own = find_own_method(method)) return own->place;
  const MarkerMethod* on_marker = find_marker_method(method);
  if (!on_marker) return std::nullopt;
  switch (on_marker->kind) {
    case MethodKind::kTell: return Place::kRead;
    case MethodKind::kStudy: return Place::kStudy;
    case MethodKind::kStep: return Place::kStep;
    case MethodKind::kMove: return Place::kMotion;
  }
  return std::nullopt;
}

}  // namespace selvage
