#include "server/dispatch/dispatcher.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/json/fields.h"
#include "server/calls/errors.h"

namespace selvage::server::dispatch {
namespace {

using methods::Schedule;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kSmallMessage = std::size_t{16} << 10;   // bytes; parsed in a fraction of a millisecond
constexpr std::size_t kLargeMessage = std::size_t{256} << 10;  // bytes; takes milliseconds and more
constexpr std::string_view kCancel = "$/cancelRequest";
constexpr const char* kBusy = "too many calls are waiting";

protocol::rpc::RpcError internal_error() {
  return {protocol::rpc::RpcCode::kInternalError, "internal error; the server's log has the details", {}};
}

protocol::rpc::RpcError unknown_method(const std::string& name) {
  return {protocol::rpc::RpcCode::kMethodNotFound, "there is no method '" + name + "'", {}};
}

// How long the call may take: as long as it asks for and, if its method may take long, no longer than the limit.
std::optional<Clock::duration> time_limit(Schedule schedule, const methods::ParsedCall& call,
                                          std::chrono::milliseconds limit) {
  std::optional<Clock::duration> time;
  if (call.deadline_ms) {
    time = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>{*call.deadline_ms});
  }
  const bool unlimited = schedule == Schedule::kInline || schedule == Schedule::kRead;
  return unlimited ? time : std::min<Clock::duration>(time.value_or(limit), limit);
}

}  // namespace

void Dispatcher::receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
                         transport::access::Reply reply) {
  jobs::ReplyOnce<std::string> once{std::move(reply), error_text(internal_error())};
  if (message.size() <= kSmallMessage) return parse(std::move(message), session, std::move(once));
  jobs::JobQueue& queue = message.size() <= kLargeMessage ? queues_.reads : queues_.parsing;
  // Shared, so that the reply is still available if the queue does not accept the job.
  const auto shared_reply = std::make_shared<jobs::ReplyOnce<std::string>>(std::move(once));
  jobs::Job job{.session = session->id,
                .lane = {},
                .quick = true,
                .caller = session->gone,
                .work = jobs::Work{[this, shared_reply, session, text = std::move(message)](auto&&) mutable {
                  parse(std::move(text), session, std::move(*shared_reply));
                }}};
  const jobs::Admission admission = queue.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  std::move (*shared_reply)(error_text(calls::not_admitted(admission, queue, kBusy)));
}

std::string Dispatcher::too_long(std::size_t limit) {
  return error_text({protocol::rpc::RpcCode::kTooLarge,
                     "the message is longer than " + std::to_string(limit) + " bytes", Json{{"limit", limit}}});
}

void Dispatcher::parse(std::string message, std::shared_ptr<transport::access::Session> session,
                       jobs::ReplyOnce<std::string> reply) {
  const std::size_t bytes = message.size();
  protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(message, server_.limits.transport.body_bytes);
  std::string{}.swap(message);  // frees it now, because it may be large
  execute_next(std::make_shared<Exchange>(Exchange{.freed = ops::FreedMemory{bytes},
                                                   .incoming = std::move(incoming),
                                                   .bytes = bytes,
                                                   .session = std::move(session),
                                                   .reply = std::move(reply),
                                                   .on_answered = on_answered_}));
}

void Dispatcher::execute_next(const std::shared_ptr<Exchange>& exchange) {
  const std::vector<protocol::rpc::Call>& calls = exchange->incoming.calls;
  while (exchange->calls_done < calls.size()) {
    const protocol::rpc::Call& call = calls[exchange->calls_done++];
    if (const auto* request = std::get_if<protocol::rpc::Request>(&call)) {
      exchange->marker_id.clear();
      const auto answered = [this, exchange, request](calls::Outcome outcome) {
        exchange->add_answer(*request, std::move(outcome));
        execute_next(exchange);
      };
      try {
        start(exchange, *request, jobs::ReplyOnce<calls::Outcome>{answered, internal_error()});
      } catch (const std::exception& error) {  // the unused reply has answered the call
        spdlog::error("a call of {} threw an exception: {}", request->method, error.what());
      }
      return;
    }
    exchange->add_refusal(std::get<protocol::rpc::BadRequest>(call));
  }
  std::move(exchange->reply)(exchange->text());
}

void Dispatcher::start(const std::shared_ptr<Exchange>& exchange, const protocol::rpc::Request& request,
                       jobs::ReplyOnce<calls::Outcome> reply) {
  if (request.method == kCancel) return std::move(reply)(cancel(request.params, exchange->session->id));
  const methods::Method* method = server_.methods.find(request.method);
  if (!method) return std::move(reply)(unknown_method(request.method));
  auto parsed = method->decode(request.params, server_);
  if (!parsed) return std::move(reply)(protocol::rpc::rpc_error(parsed.error()));

  exchange->marker_id = parsed->marker_id;
  const auto call = std::make_shared<calls::OpenCall>(exchange->session, std::move(reply));
  if (const auto time = time_limit(method->schedule, *parsed, server_.limits.call)) {
    calls::OpenCall::set_deadline(call, clock_, Clock::now() + *time);
  }
  if (request.id) calls_.add(*request.id, call);
  schedule(method->schedule, *std::move(parsed), exchange, call);
}

void Dispatcher::schedule(Schedule schedule, methods::ParsedCall parsed, const std::shared_ptr<Exchange>& exchange,
                          const std::shared_ptr<calls::OpenCall>& call) {
  if (schedule == Schedule::kInline) return parsed.run(call);
  const bool is_read = schedule == Schedule::kRead || schedule == Schedule::kLongRead;
  const bool small = exchange->bytes <= kLargeMessage && !parsed.on_large_marker;
  jobs::JobQueue& queue = is_read ? queues_.reads : queues_.motions;
  jobs::Job job{.session = exchange->session->id,
                // Retries of a read share a lane, so that the later one finds the answer of the earlier one.
                .lane = is_read ? parsed.op_id : parsed.marker_id,
                .quick = small && (schedule == Schedule::kRead || schedule == Schedule::kChange),
                .caller = call->stop(),
                .work = jobs::Work{[exchange, run = std::move(parsed.run), call](const std::stop_token& stop) {
                  // Nobody waits for the outcome of a call that was cancelled before its turn came.
                  if (call->abandoned() && !call->settle()) return;
                  const std::stop_callback on_drain{stop, [&call] { call->drain(); }};
                  run(call);
                }}};
  const jobs::Admission admission = queue.submit(job);
  if (admission != jobs::Admission::kAccepted) call->answer(calls::not_admitted(admission, queue, kBusy));
}

calls::Outcome Dispatcher::cancel(const Json& params, std::uint64_t session) {
  protocol::json::Mistake mistake;
  protocol::json::Fields fields{params, "", mistake};
  const Json* id = fields.maybe_any("id");
  fields.finish();
  if (!id) mistake.add(ErrorCode::kMissingField, "the field is missing; it is required", "/id");
  if (mistake) return protocol::rpc::rpc_error(mistake.error());
  return Json{{"cancelled", calls_.cancel(*id, session)}};
}

}  // namespace selvage::server::dispatch
