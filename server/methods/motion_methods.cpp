// The methods that work on one marker and that the command line runs, too: motions, and reads that compute something.
#include <chrono>
#include <utility>

#include "protocol/calls/motion.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/marker_methods.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::calls::MarkerCall;
using protocol::calls::MarkerMethod;
using protocol::calls::MethodKind;

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>{since}.count();
}

// Sends `$/progress` after each round if the call asks for it and its connection can be notified.
std::function<void(const scene::Round&)> progress_sender(const protocol::calls::MotionCall& about,
                                                         const std::shared_ptr<transport::access::Session>& session,
                                                         Resolution resolution) {
  if (about.progress_token.is_null() || !session->notify) return [](const scene::Round&) {};
  return [&about, session, resolution](const scene::Round& round) {
    session->notify(protocol::json::to_text(protocol::rpc::notification(
        "$/progress",
        {{"token", about.progress_token}, {"round", round.number}, {"length", to_decimal(round.length, resolution)}})));
  };
}

// The answer to a call that was stopped before it had a result.
protocol::rpc::RpcError stopped_without_result(Error error, calls::StopCause cause) {
  if (is_abandoned(cause)) return calls::abandoned();
  if (cause != calls::StopCause::kDeadline) return calls::shutting_down();
  error.message = "the deadline passed: " + error.message;
  return rpc_error(error, protocol::rpc::RpcCode::kMotionRefused);
}

// `stop` of the answer is the motion's stop reason, except that a motion that its deadline stopped says so.
void name_stop_cause(Json& fields, calls::StopCause cause) {
  const auto stop = fields.find("stop");
  const bool stopped = stop != fields.end() && *stop == protocol::calls::name_of(scene::StopReason::kCancelled);
  if (stopped && cause == calls::StopCause::kDeadline) *stop = "deadline";
}

calls::Outcome execute(const MarkerMethod& method, const MarkerCall& request, const ServerContext& server,
                       calls::OpenCall& call) {
  const protocol::calls::MotionCall& about = request.about;
  const std::string& id = about.marker_id;
  if (const auto earlier = server.committer.earlier_answer(id, about.op_id, method.name)) return *earlier;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(id);
  if (about.base_revision && *about.base_revision != now->revision) {
    return calls::revision_mismatch(id, *about.base_revision, now->revision);
  }
  if (call.abandoned()) return calls::abandoned();

  protocol::execution::StageTimer timer{now_ms()};
  scene::Run run{server.sums, call.stop(), {}, &server.executor};
  run.observer.on_stage = [&timer](scene::Stage stage) { timer.enter(stage, now_ms()); };
  run.observer.on_round = progress_sender(about, call.session(), now->file->marker.resolution);
  static const protocol::calls::Engine kEngine;
  auto answer = request.run(*now->file, protocol::calls::MethodContext{kEngine, run, now->laid_out.get()});
  const calls::StopCause cause = call.stop_cause();
  if (!answer && answer.error().code == ErrorCode::kStoppedEarly) return stopped_without_result(answer.error(), cause);
  if (!answer) return rpc_error(answer.error(), protocol::methods::code_of_run(method, answer.error()));
  if (is_abandoned(cause)) return calls::abandoned();

  name_stop_cause(answer->fields, cause);
  if (about.timing) protocol::methods::tell_times(answer->fields, timer.times(now_ms()), server.sums.counts());
  if (!answer->next) {
    Json result = protocol::methods::result_json(id, now->revision, answer->fields);
    if (!about.commit || !call.settle()) return result;
    return server.committer.keep_unchanged(method.name, id, about.op_id, std::move(result));
  }
  return server.committer.commit(
      {method.name, id, *now, protocol::edits::with_marker(*now->file, *std::move(answer->next)),
       store::Origin::kChange, about.op_id, answer->fields},
      call);
}

Schedule schedule_of(MethodKind kind) {
  switch (kind) {
    case MethodKind::kTell: return Schedule::kRead;
    case MethodKind::kStudy: return Schedule::kLongRead;
    case MethodKind::kStep: return Schedule::kChange;
    case MethodKind::kMove: return Schedule::kLongChange;
  }
  return Schedule::kLongChange;
}

}  // namespace

Method method_on_marker(const MarkerMethod& method) {
  return method_on_marker(method, method.read);
}

Method method_on_marker(const MarkerMethod& method, ReadMarkerCall read) {
  auto decode = [&method, read = std::move(read)](const Json& params,
                                                  const ServerContext& server) -> Result<ParsedCall> {
    auto decoded = read(params);
    if (!decoded) return decoded.error();
    ParsedCall call;
    call.marker_id = decoded->about.marker_id;
    call.op_id = decoded->about.op_id.value_or("");
    call.deadline_ms = decoded->about.deadline_ms;
    call.run = [&method, request = *std::move(decoded), &server](const std::shared_ptr<calls::OpenCall>& open) {
      open->answer(execute(method, request, server, *open));
    };
    return call;
  };
  return {method.name, schedule_of(method.kind), std::move(decode)};
}

std::vector<Method> motion_methods() {
  std::vector<Method> methods;
  for (const MarkerMethod& method : protocol::methods::marker_methods()) methods.push_back(method_on_marker(method));
  return methods;
}

}  // namespace selvage::server::methods
