#include "server/methods.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "protocol/codec.h"
#include "server/version.h"

namespace selvage {
namespace {

RpcError unknown_marker(const std::string& id) {
  return {RpcCode::kUnknownMarker, "no marker '" + id + "' is open", {}};
}

RpcError revision_mismatch(const std::string& id, Revision wanted, Revision present) {
  return {RpcCode::kRevisionMismatch,
          "marker '" + id + "' is at revision " + std::to_string(present) + ", not " + std::to_string(wanted),
          Json{{"revision", present}}};
}

RpcError limit_reached(const std::string& what, std::size_t limit) {
  return {RpcCode::kLimit, what + ": the limit is " + std::to_string(limit), Json{{"limit", limit}}};
}

RpcError caller_gone() {
  return {RpcCode::kCancelled, "the connection closed before the call ended", {}};
}

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>{since}.count();
}

struct OwnMethod {
  std::string_view name;
  Place place{};
  Outcome (Methods::*run)(const Json& params);
};
constexpr std::array kOwnMethods{
    OwnMethod{"engine.info", Place::kAtOnce, &Methods::engine_info},
    OwnMethod{"marker.open", Place::kRead, &Methods::marker_open},
    OwnMethod{"marker.close", Place::kRead, &Methods::marker_close},
};
const OwnMethod* find_own_method(std::string_view name) {
  const auto* const found = std::find_if(kOwnMethods.begin(), kOwnMethods.end(),
                                         [name](const OwnMethod& method) { return method.name == name; });
  return found == kOwnMethods.end() ? nullptr : found;
}

}  // namespace

Outcome Methods::engine_info(const Json& params) {
  if (const auto none = decode_no_params(params); !none) return rpc_error(none.error());
  EngineInfo info;
  info.version = kVersion;
  info.workers = static_cast<int>(workers_);
  info.markers = store_.count();
  info.max_request_bytes = limits_.transport.body_bytes;
  info.cache = sums_.counts();
  for (const OwnMethod& method : kOwnMethods) info.methods.push_back(method.name);
  for (const MarkerMethod& method : marker_methods()) info.methods.push_back(method.name);
  Json result = encode(info);
  result["limits"].update(Json{{"openMarkers", limits_.open_markers},
                               {"waitingMotions", limits_.waiting_motions},
                               {"waitingReads", limits_.waiting_reads},
                               {"connections", limits_.transport.connections},
                               {"callsPerConnection", limits_.transport.calls_per_connection}});
  return result;
}

Outcome Methods::marker_open(const Json& params) {
  auto wanted = decode_marker_open(params);
  if (!wanted) return rpc_error(wanted.error());
  const auto opened = store_.open(std::move(wanted->file));
  if (!opened) return limit_reached("too many open markers", store_.limit());
  const MarkerFile& file = *opened->first.file;
  MarkerOpened answer;
  answer.marker_id = opened->id;
  answer.revision = opened->first.revision;
  answer.pieces = file.marker.pieces.size();
  answer.length = to_decimal(length_of(file.marker), file.marker.resolution);
  answer.utilisation = utilisation_of(file.marker);
  answer.valid = is_valid(file.marker);
  answer.notes = file.notes;
  return encode(answer);
}

Outcome Methods::marker_close(const Json& params) {
  const auto wanted = decode_marker_close(params);
  if (!wanted) return rpc_error(wanted.error());
  if (!store_.close(wanted->marker_id)) return unknown_marker(wanted->marker_id);
  return encode(MarkerClosed{wanted->marker_id});
}

Outcome Methods::call_on_marker(const MarkerMethod& method, const Json& params, const Stops& stops) {
  const auto call = method.read(params);
  if (!call) return rpc_error(call.error());
  const std::string& id = call->about.marker_id;
  const auto current = store_.current(id);
  if (!current) return unknown_marker(id);
  const Revision base = current->revision;
  if (const auto& wanted = call->about.base_revision; wanted && *wanted != base) {
    return revision_mismatch(id, *wanted, base);
  }
  if (stops.caller.stop_requested()) return caller_gone();

  StageTimer timer{now_ms()};
  Observer observer;
  observer.on_stage = [&timer](Stage stage) { timer.enter(stage, now_ms()); };
  auto answer = call->run(*current->file, Means{engine_, sums_, stops.any, observer});
  if (!answer) return rpc_error(answer.error(), code_of_run(method, answer.error()));
  if (stops.caller.stop_requested()) return caller_gone();

  if (call->about.timing) tell_times(answer->fields, timer.times(now_ms()), sums_.counts());
  if (!answer->next) return result_json(id, base, answer->fields);
  MarkerFile next = *current->file;
  next.marker = *std::move(answer->next);
  const Commit commit = store_.commit(id, base, std::move(next));
  if (commit.outcome == Commit::Outcome::kClosed) return unknown_marker(id);
  if (commit.outcome == Commit::Outcome::kMismatch) return revision_mismatch(id, base, commit.revision);
  return result_json(id, commit.revision, answer->fields);
}

Outcome Methods::call(std::string_view method, const Json& params, const Stops& stops) {
  if (const OwnMethod* own = find_own_method(method)) return (this->*own->run)(params);
  return call_on_marker(*find_marker_method(method), params, stops);
}

std::optional<Place> place_of(std::string_view method) {
  if (const OwnMethod* own = find_own_method(method)) return own->place;
  const MarkerMethod* on_marker = find_marker_method(method);
  if (!on_marker) return std::nullopt;
  return on_marker->motion ? Place::kMotion : Place::kRead;
}

}  // namespace selvage
