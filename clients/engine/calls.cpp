#include "clients/engine/calls.h"

#include <chrono>
#include <optional>
#include <utility>

#include "core/marker/figures.h"
#include "protocol/calls/answer.h"
#include "protocol/describe/openrpc.h"
#include "protocol/edits/changes.h"
#include "protocol/execution/time_limit.h"
#include "protocol/methods/daemon/engine.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/methods/method_table.h"

namespace selvage::engine {
namespace {

namespace daemon = protocol::methods::daemon;
using protocol::calls::Method;
using protocol::calls::ParsedCall;
using protocol::execution::StageTimer;
using protocol::execution::TimeLimit;
using protocol::rpc::RpcError;
using protocol::schema::encode;

double now_ms() {
  return std::chrono::duration<double, std::milli>{TimeLimit::Clock::now().time_since_epoch()}.count();
}

using Serve = Outcome (*)(ParsedCall& call, const Context& context);

Outcome open(ParsedCall& call, const Context& context) {
  const OpenMarkers::Opened opened = context.markers.open(call.take_params<daemon::OpenParams>().file);
  const Current now = opened.marker->current();
  return encode(daemon::opened(opened.id, now.revision, *now.file));
}

Outcome list(ParsedCall&, const Context& context) {
  daemon::ListResult result;
  for (const OpenMarkers::Opened& open : context.markers.all()) {
    const Current now = open.marker->current();
    const marker::Figures figures = figures_of(now.file->marker);
    result.markers.push_back({.at = {open.id, now.revision},
                              .name = now.file->marker.name,
                              .pieces = now.file->marker.pieces.size(),
                              .unplaced = protocol::calls::unplaced_count(now.file->marker),
                              .length = to_decimal(figures.length, now.file->marker.resolution),
                              .utilisation = figures.utilisation});
  }
  return encode(result);
}

Outcome close(ParsedCall& call, const Context& context) {
  const std::string& id = call.params_as<daemon::CloseParams>().marker_id;
  if (!context.markers.close(id)) return protocol::calls::not_open(id);
  return encode(daemon::CloseResult{id});
}

Outcome apply(ParsedCall& call, const Context& context) {
  const auto& params = call.params_as<protocol::edits::ApplyParams>();
  const auto& [id, base, op_id] = params.call;
  const auto marker = context.markers.find(id);
  if (!marker) return protocol::calls::not_open(id);
  const auto turn = marker->turn();
  const Current now = marker->current();
  if (base && *base != now.revision) return protocol::calls::revision_mismatch(id, *base, now.revision);
  auto after = apply_edits(*now.file, params.edits);
  if (!after) return protocol::rpc::rpc_error(after.error());
  const auto result = protocol::edits::apply_result(id, now.revision, *now.file, *after);
  if (!result.committed.change.none())
    marker->commit(std::make_shared<const MarkerFile>(*std::move(after)), Origin::kChange);
  return encode(result);
}

template <Origin origin>
Outcome undo_or_redo(ParsedCall& call, const Context& context) {
  const auto& [id, base, op_id] = call.params_as<protocol::edits::ChangeParams>();
  const auto marker = context.markers.find(id);
  if (!marker) return protocol::calls::not_open(id);
  const auto turn = marker->turn();
  const Current now = marker->current();
  if (base && *base != now.revision) return protocol::calls::revision_mismatch(id, *base, now.revision);
  const State next = marker->peek(origin);
  if (!next) return protocol::calls::nothing_to_undo(origin == Origin::kUndo);
  const protocol::edits::CommittedChange result{{id, now.revision + 1},
                                                protocol::edits::change_between(*now.file, *next)};
  marker->commit(next, origin);
  return encode(result);
}

Outcome info(ParsedCall&, const Context& context);

Outcome discover(ParsedCall&, const Context&) {
  return protocol::describe::openrpc_document(SELVAGE_VERSION);
}

struct Served {
  std::string_view method;
  Serve serve;
};
// These are served in addition to the methods that the table of methods can run.
constexpr Served kServed[] = {{"engine.info", info},
                              {"rpc.discover", discover},
                              {"marker.open", open},
                              {"marker.list", list},
                              {"marker.close", close},
                              {"marker.apply", apply},
                              {"marker.undo", undo_or_redo<Origin::kUndo>},
                              {"marker.redo", undo_or_redo<Origin::kRedo>}};

Serve served_here(std::string_view method) {
  for (const Served& served : kServed) {
    if (served.method == method) return served.serve;
  }
  return nullptr;
}

Outcome info(ParsedCall&, const Context& context) {
  daemon::EngineInfo info = daemon::engine_info(protocol::json::kMaxFileBytes);
  info.version = SELVAGE_VERSION;
  for (const Method& method : protocol::methods::method_table().all()) {
    if (method.on_marker || served_here(method.name)) info.methods.push_back(method.name);
  }
  info.workers = context.threads;
  info.markers = context.markers.all().size();
  info.instance = context.markers.identity();
  info.cache = protocol::calls::cache_counts_of(context.sums.counts());
  return encode(info);
}

// The error to answer when a run has failed or was stopped.
RpcError error_of_run(const Method& method, const Error& error, const TimeLimit& limit) {
  if (error.code != ErrorCode::kStoppedEarly)
    return protocol::rpc::rpc_error(error, protocol::calls::code_of_run(method, error));
  return limit.is_up() ? protocol::calls::past_deadline(error) : protocol::calls::abandoned();
}

// Runs a method of the table on the marker's current state.  REQUIRES: the caller holds the turn when it is a change.
Outcome run_on(OpenMarker& marker, const Method& method, const ParsedCall& call, const Caller& caller,
               const Context& context) {
  const auto begin = TimeLimit::Clock::now();
  const std::string& id = call.about.marker_id;
  const Current now = marker.current();
  if (const auto base = call.about.base_revision; base && *base != now.revision)
    return protocol::calls::revision_mismatch(id, *base, now.revision);
  std::optional<std::chrono::duration<double>> time;
  if (call.about.deadline_ms) time = std::chrono::duration<double, std::milli>{*call.about.deadline_ms};
  const TimeLimit limit{caller.stop, begin, time};

  StageTimer timer{now_ms()};
  scene::Run run{context.sums, limit.token(), {}, &context.executor};
  run.observer.on_stage = [&timer](scene::Stage stage) { timer.enter(stage, now_ms()); };
  run.observer.on_round = [&caller, resolution = now.file->marker.resolution](const scene::Round& round) {
    Round reported{round.number, to_decimal(round.length, resolution), std::nullopt, round.nodes};
    if (round.bound) reported.bound = to_decimal(*round.bound, resolution);
    caller.on_round(reported);
  };
  auto answer = call.run(*now.file, {run, nullptr, [&limit] { return limit.is_up(); }, {}, limit.left()});
  if (!answer) return error_of_run(method, answer.error(), limit);
  if (caller.stop.stop_requested()) return protocol::calls::abandoned();
  if (call.about.timing) protocol::calls::add_times(answer->fields, timer.times(now_ms()), context.sums.counts());
  const Revision revision = now.revision + (answer->next ? 1 : 0);
  if (answer->next) {
    marker.commit(std::make_shared<const MarkerFile>(protocol::edits::with_marker(*now.file, *std::move(answer->next))),
                  Origin::kChange);
  }
  return protocol::calls::result_json(id, revision, answer->fields);
}

}  // namespace

Outcome serve(const protocol::rpc::Request& request, const Caller& caller, const Context& context) {
  const Method* method = protocol::methods::find_method(request.method);
  if (!method) return protocol::calls::unknown_method(request.method);
  auto call = method->read(request.params);
  if (!call) return protocol::rpc::rpc_error(call.error());
  if (const Serve serve_here = served_here(request.method)) return serve_here(*call, context);
  if (!call->run) {
    return RpcError{protocol::rpc::RpcCode::kMethodNotFound,
                    request.method + " needs a daemon and is not available in the embedded engine",
                    {}};
  }
  const auto marker = context.markers.find(call->about.marker_id);
  if (!marker) return protocol::calls::not_open(call->about.marker_id);
  std::unique_lock<std::mutex> turn;
  if (!call->lane().empty() && call->kind != protocol::calls::MethodKind::kRead) turn = marker->turn();
  return run_on(*marker, *method, *call, caller, context);
}

}  // namespace selvage::engine
