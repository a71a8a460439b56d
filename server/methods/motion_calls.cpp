// Calls of the methods that work on one marker, above all the motions.
#include <chrono>
#include <utility>

#include "protocol/edits/changes.h"
#include "server/calls/refusals.h"
#include "server/methods/methods.h"

namespace selvage::server::methods {
namespace {

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>{since}.count();
}

// Tells the caller of each round, when it asked for it and can be told.
std::function<void(const scene::Round&)> round_teller(const protocol::calls::MotionCall& about,
                                                      const std::shared_ptr<transport::access::Session>& session,
                                                      Resolution resolution) {
  if (about.progress_token.is_null() || !session->notify) return [](const scene::Round&) {};
  return [&about, session, resolution](const scene::Round& round) {
    session->notify(protocol::json::to_text(protocol::rpc::notification(
        "$/progress",
        {{"token", about.progress_token}, {"round", round.number}, {"length", to_decimal(round.length, resolution)}})));
  };
}

// A motion that was stopped by its deadline says so.
void name_deadline(Json& fields, const calls::OpenCall& call) {
  const auto stop = fields.find("stop");
  if (call.late() && stop != fields.end() && *stop == "cancelled") *stop = "deadline";
}

// Of a call that was stopped before it had anything to answer with, by whoever stopped it.
protocol::rpc::RpcError without_answer(Error why, const CallTurn& turn) {
  if (turn.call.left().stop_requested()) return calls::nobody_waits();
  if (!turn.call.late()) return calls::going_down();
  why.message = "the time is up: " + why.message;
  return rpc_error(why, protocol::rpc::RpcCode::kMotionRefused);
}

}  // namespace

calls::Outcome Methods::call_on_marker(const protocol::calls::MarkerMethod& method, const Json& params,
                                       const CallTurn& turn) {
  const auto call = method.read(params);
  if (!call) return protocol::rpc::rpc_error(call.error());
  const protocol::calls::MotionCall& about = call->about;
  const std::string& id = about.marker_id;
  if (const auto again = replay(id, about.op_id, method.name)) return *again;
  const auto now = store_.current(id);
  if (!now) return calls::unknown_marker(id);
  if (about.base_revision && *about.base_revision != now->revision) {
    return calls::revision_mismatch(id, *about.base_revision, now->revision);
  }
  if (turn.call.left().stop_requested()) return calls::nobody_waits();

  protocol::execution::StageTimer timer{now_ms()};
  scene::Run run{sums_, turn.stop, {}, &executor_};
  run.observer.on_stage = [&timer](scene::Stage stage) { timer.enter(stage, now_ms()); };
  run.observer.on_round = round_teller(about, turn.call.session(), now->file->marker.resolution);
  auto answer = call->run(*now->file, protocol::calls::MethodContext{engine_, run, now->laid_out.get()});
  if (!answer && answer.error().code == ErrorCode::kStoppedEarly) return without_answer(answer.error(), turn);
  if (!answer) return rpc_error(answer.error(), protocol::methods::code_of_run(method, answer.error()));
  if (turn.call.left().stop_requested()) return calls::nobody_waits();

  name_deadline(answer->fields, turn.call);
  if (about.timing) protocol::methods::tell_times(answer->fields, timer.times(now_ms()), sums_.counts());
  if (!answer->next) {
    Json result = protocol::methods::result_json(id, now->revision, answer->fields);
    if (!about.commit || !turn.call.settle()) return result;
    return unchanged(method.name, id, about.op_id, std::move(result));
  }
  return commit({method.name, id, *now, protocol::edits::with_marker(*now->file, *std::move(answer->next)),
                 store::Origin::kChange, about.op_id, answer->fields},
                turn);
}

}  // namespace selvage::server::methods
