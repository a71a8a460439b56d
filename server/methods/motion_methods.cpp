// The methods that work on one marker and that the command line also runs: motions, and reads that need computation.
#include <chrono>
#include <utility>

#include "protocol/calls/answer.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/daemon/progress.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using calls::StopCause;
using protocol::calls::Method;
using protocol::calls::MethodAnswer;
using protocol::calls::ParsedCall;

double now_ms() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>{since}.count();
}

// Sends `$/progress` after each round if the call asks for it and its connection can be notified.
std::function<void(const scene::Round&)> progress_sender(const protocol::calls::CommonParams& about,
                                                         const std::shared_ptr<transport::access::Session>& session,
                                                         Resolution resolution) {
  if (!about.progress_token || !session->notify) return [](const scene::Round&) {};
  return [token = *about.progress_token, session, resolution](const scene::Round& round) {
    const auto progress = protocol::methods::daemon::progress_of(token, round, resolution);
    session->notify(
        protocol::json::to_text(protocol::rpc::notification("$/progress", protocol::schema::encode(progress))));
  };
}

// The answer to a call that was stopped before it had a result.
protocol::rpc::RpcError stopped_without_result(Error error, StopCause cause) {
  if (is_abandoned(cause)) return calls::abandoned();
  if (cause != StopCause::kDeadline) return calls::shutting_down();
  return protocol::calls::past_deadline(std::move(error));
}

// Runs the call on this revision, and adds the times to the result if the call asks for them.
Result<MethodAnswer> run(const ParsedCall& parsed, const store::Committed& now, const ServerContext& server,
                         const calls::OpenCall& call) {
  protocol::execution::StageTimer timer{now_ms()};
  scene::Run run{server.sums, call.stop(), {}, &server.executor};
  run.observer.on_stage = [&timer](scene::Stage stage) { timer.enter(stage, now_ms()); };
  run.observer.on_round = progress_sender(parsed.about, call.session(), now.file->marker.resolution);
  const auto past_deadline = [&call] { return call.stop_cause() == StopCause::kDeadline; };
  const auto library = [&server](const Marker& order, std::size_t most) {
    return server.library.markers_near(order, most);
  };
  auto answer = parsed.run(*now.file, {run, now.laid_out.get(), past_deadline, library, call.time_left()});
  if (answer && parsed.about.timing) {
    protocol::calls::add_times(answer->fields, timer.times(now_ms()), server.sums.counts());
  }
  return answer;
}

calls::Outcome execute(const Method& method, const ParsedCall& parsed, const ServerContext& server,
                       calls::OpenCall& call) {
  const protocol::calls::CommonParams& about = parsed.about;
  const std::string& id = about.marker_id;
  if (const auto earlier = server.committer.earlier_answer(id, about.op_id, method.name, call)) return *earlier;
  const auto now = server.store.current(id);
  if (!now) return calls::unknown_marker(server.store, id);
  if (about.base_revision && *about.base_revision != now->revision) {
    return calls::revision_mismatch(id, *about.base_revision, now->revision);
  }
  if (call.abandoned()) return calls::abandoned();

  auto answer = run(parsed, *now, server, call);
  if (!answer && answer.error().code == ErrorCode::kStoppedEarly) {
    return stopped_without_result(answer.error(), call.stop_cause());
  }
  if (!answer) return rpc_error(answer.error(), protocol::calls::code_of_run(method, answer.error()));
  if (call.abandoned()) return calls::abandoned();
  if (!answer->next) {
    Json result = protocol::calls::result_json(id, now->revision, answer->fields);
    if (!about.commit || !call.settle()) return result;
    return server.committer.keep_unchanged(method.name, id, about.op_id, std::move(result), call);
  }
  return server.committer.commit(
      {method.name, id, *now, protocol::edits::with_marker(*now->file, *std::move(answer->next)),
       store::Origin::kChange, about.op_id, protocol::calls::result_json(id, now->revision + 1, answer->fields)},
      call);
}

}  // namespace

Handler motion_handler(const Method& method) {
  return [method](const ParsedCall& parsed, const ServerContext& server, const std::shared_ptr<calls::OpenCall>& call) {
    call->answer(execute(method, parsed, server, *call));
  };
}

}  // namespace selvage::server::methods
