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
  return {RpcCode::kCancelled, "the connection closed before the motion ended", {}};
}

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>{since}.count();
}

}  // namespace

Outcome Methods::engine_info(const Json& params, const Stops&) {
  if (const auto none = decode_no_params(params); !none) return rpc_error(none.error());
  EngineInfo info;
  info.version = kVersion;
  info.workers = static_cast<int>(workers_);
  info.markers = store_.count();
  info.max_request_bytes = limits_.transport.body_bytes;
  info.cache = sums_.counts();
  Json result = encode(info);
  result["limits"].update(Json{{"openMarkers", limits_.open_markers},
                               {"waitingMotions", limits_.waiting_motions},
                               {"waitingReads", limits_.waiting_reads},
                               {"connections", limits_.transport.connections},
                               {"callsPerConnection", limits_.transport.calls_per_connection}});
  return result;
}

Outcome Methods::marker_open(const Json& params, const Stops&) {
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

Outcome Methods::marker_get(const Json& params, const Stops&) {
  const auto wanted = decode_marker_get(params);
  if (!wanted) return rpc_error(wanted.error());
  const auto current = store_.current(wanted->marker_id);
  if (!current) return unknown_marker(wanted->marker_id);
  auto document = marker_document(*current->file, wanted->format);
  if (!document) return rpc_error(document.error());
  return encode(MarkerGot{wanted->marker_id, current->revision, wanted->format, *std::move(document)});
}

Outcome Methods::marker_check(const Json& params, const Stops&) {
  const auto wanted = decode_marker_check(params);
  if (!wanted) return rpc_error(wanted.error());
  const auto current = store_.current(wanted->marker_id);
  if (!current) return unknown_marker(wanted->marker_id);
  const Marker& marker = current->file->marker;
  Json validity = validity_json(marker, engine_.check(marker, sums_));
  return encode(MarkerChecked{wanted->marker_id, current->revision, std::move(validity)});
}

Outcome Methods::marker_close(const Json& params, const Stops&) {
  const auto wanted = decode_marker_close(params);
  if (!wanted) return rpc_error(wanted.error());
  if (!store_.close(wanted->marker_id)) return unknown_marker(wanted->marker_id);
  return encode(MarkerClosed{wanted->marker_id});
}

Outcome Methods::motion_compact(const Json& params, const Stops& stops) {
  const auto wanted = decode_motion_compact(params);
  if (!wanted) return rpc_error(wanted.error());
  const std::string& id = wanted->marker_id;
  const auto current = store_.current(id);
  if (!current) return unknown_marker(id);
  const Revision base = current->revision;
  if (wanted->base_revision && *wanted->base_revision != base) {
    return revision_mismatch(id, *wanted->base_revision, base);
  }
  if (stops.caller.stop_requested()) return caller_gone();

  StageTimer timer{now_ms()};
  Observer observer;
  observer.on_stage = [&timer](Stage stage) { timer.enter(stage, now_ms()); };
  const Marker& before = current->file->marker;
  auto compaction =
      engine_.compact(before, settings_of(wanted->accuracy, wanted->rounds), sums_, stops.any, observer);
  if (!compaction) return rpc_error(compaction.error(), RpcCode::kMotionRefused);
  if (stops.caller.stop_requested()) return caller_gone();

  MotionCompacted answer;
  answer.marker_id = id;
  answer.revision = base;
  answer.timing = wanted->timing;
  answer.figures = figures_of(*compaction, timer.times(now_ms()), sums_.counts());
  answer.placements = changed_placements(before, compaction->marker);
  if (wanted->commit && !answer.placements.empty()) {
    MarkerFile next = *current->file;
    next.marker = std::move(compaction->marker);
    const Commit commit = store_.commit(id, base, std::move(next));
    if (commit.outcome == Commit::Outcome::kClosed) return unknown_marker(id);
    if (commit.outcome == Commit::Outcome::kMismatch) return revision_mismatch(id, base, commit.revision);
    answer.revision = commit.revision;
  }
  return encode(answer);
}

std::optional<Method> find_method(std::string_view name) {
  static constexpr std::array<Method, 6> kMethods{{
      {"engine.info", Place::kAtOnce, &Methods::engine_info},
      {"marker.open", Place::kRead, &Methods::marker_open},
      {"marker.get", Place::kRead, &Methods::marker_get},
      {"marker.check", Place::kRead, &Methods::marker_check},
      {"marker.close", Place::kRead, &Methods::marker_close},
      {"motion.compact", Place::kMotion, &Methods::motion_compact},
  }};
  const auto found = std::find_if(kMethods.begin(), kMethods.end(),
                                  [name](const Method& method) { return method.name == name; });
  if (found == kMethods.end()) return std::nullopt;
  return *found;
}

}  // namespace selvage
