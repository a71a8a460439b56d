#include "server/dispatch/dispatcher.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/calls/call_fields.h"
#include "server/calls/refusals.h"
#include "server/ops/freed_memory.h"

namespace selvage::server::dispatch {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSmallMessage = std::size_t{16} << 10;   // bytes; parsed in a fraction of a millisecond
constexpr std::size_t kLargeMessage = std::size_t{256} << 10;  // bytes; takes milliseconds and more
constexpr std::string_view kCancel = "$/cancelRequest";

protocol::rpc::RpcError internal_error() {
  return {protocol::rpc::RpcCode::kInternalError, "the server failed; its log says why", {}};
}

protocol::rpc::RpcError refused(jobs::Admission admission, const jobs::JobQueue& queue) {
  if (admission == jobs::Admission::kDraining) return calls::going_down();
  return {protocol::rpc::RpcCode::kBusy, "too many calls are waiting", Json{{"retryAfterMs", queue.retry_after_ms()}}};
}

std::string text_of(const protocol::rpc::RpcError& error) {
  return protocol::json::to_text(error_response(nullptr, error));
}

std::string text_field(const Json& fields, std::string_view key) {
  const auto found = fields.is_object() ? fields.find(key) : fields.end();
  return found != fields.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

// The marker a call is about: of its params, or of the answer that opened it.  Empty: none.
std::string marker_of(const Json& fields) {
  return text_field(fields, "markerId");
}

// How long the call may take by its own words; checked as a parameter later, together with the others.
std::optional<Clock::duration> asked_time(const Json& params) {
  const auto found = params.is_object() ? params.find("deadlineMs") : params.end();
  if (found == params.end() || !found->is_number()) return std::nullopt;
  const double milliseconds = found->get<double>();
  if (!(milliseconds >= protocol::calls::kDeadlines.least && milliseconds <= protocol::calls::kDeadlines.most))
    return std::nullopt;
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>{milliseconds});
}

}  // namespace

struct Dispatcher::Exchange {
  ops::FreedMemory freed;  // first: goes when all the rest has gone
  protocol::rpc::Incoming incoming;
  std::size_t bytes{};
  std::shared_ptr<transport::access::Session> session;
  jobs::ReplyOnce<std::string> reply;
  const ops::OnAnswered& on_answered;
  Clock::time_point began{Clock::now()};
  std::size_t calls_done{};
  std::vector<std::string> answers{};

  // The answer to the call that is under way.
  void settle(const protocol::rpc::Request& request, calls::Outcome outcome) {
    ops::AnsweredRequest line{.method = request.method, .marker = marker_of(request.params), .bytes_in = bytes};
    line.milliseconds = std::chrono::duration<double, std::milli>{Clock::now() - began}.count();
    if (const auto* error = std::get_if<protocol::rpc::RpcError>(&outcome)) {
      line.code = static_cast<int>(error->code);
    } else if (const auto* result = std::get_if<Json>(&outcome); result && line.marker.empty()) {
      line.marker = marker_of(*result);
    }
    if (request.id) {
      answers.push_back(answer_text(*request.id, std::move(outcome)));
      line.bytes_out = answers.back().size();
    }
    on_answered(line);
  }

  static std::string answer_text(const Json& id, calls::Outcome outcome) {
    if (const auto* error = std::get_if<protocol::rpc::RpcError>(&outcome))
      return protocol::json::to_text(error_response(id, *error));
    if (auto* result = std::get_if<Json>(&outcome))
      return protocol::json::to_text(protocol::rpc::response(id, std::move(*result)));
    return protocol::rpc::response_text(id, *std::get<store::SharedText>(outcome));
  }

  // All answers as one text; empty when every call was a notification.
  [[nodiscard]] std::string text() {
    if (answers.empty()) return {};
    if (!incoming.batch) return std::move(answers.front());
    std::string all;
    for (const std::string& answer : answers) all += (all.empty() ? "[" : ",") + answer;
    return all + "]";
  }
};

void Dispatcher::receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
                         transport::access::Reply reply) {
  jobs::ReplyOnce<std::string> once{std::move(reply), text_of(internal_error())};
  if (message.size() <= kSmallMessage) return take_apart(std::move(message), session, std::move(once));
  jobs::JobQueue& queue = message.size() <= kLargeMessage ? reads_ : parsing_;
  // Shared, so that the reply is still at hand when the queue refuses.
  const auto held = std::make_shared<jobs::ReplyOnce<std::string>>(std::move(once));
  jobs::Job job{.session = session->id,
                .lane = {},
                .quick = true,
                .caller = session->gone,
                .work = jobs::Work{[this, held, session, text = std::move(message)](auto&&) mutable {
                  take_apart(std::move(text), session, std::move(*held));
                }}};
  const jobs::Admission admission = queue.submit(job);
  if (admission != jobs::Admission::kAccepted) std::move (*held)(text_of(refused(admission, queue)));
}

std::string Dispatcher::too_long(std::size_t limit) {
  return text_of({protocol::rpc::RpcCode::kTooLarge, "the message is longer than " + std::to_string(limit) + " bytes",
                  Json{{"limit", limit}}});
}

void Dispatcher::take_apart(std::string message, std::shared_ptr<transport::access::Session> session,
                            jobs::ReplyOnce<std::string> reply) {
  const std::size_t bytes = message.size();
  protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(message, longest_message_);
  std::string{}.swap(message);  // has served; it may be large
  next(std::make_shared<Exchange>(Exchange{.freed = ops::FreedMemory{bytes},
                                           .incoming = std::move(incoming),
                                           .bytes = bytes,
                                           .session = std::move(session),
                                           .reply = std::move(reply),
                                           .on_answered = on_answered_}));
}

void Dispatcher::next(const std::shared_ptr<Exchange>& exchange) {
  const std::vector<protocol::rpc::Call>& calls = exchange->incoming.calls;
  while (exchange->calls_done < calls.size()) {
    const protocol::rpc::Call& call = calls[exchange->calls_done++];
    if (const auto* request = std::get_if<protocol::rpc::Request>(&call)) {
      const auto answered = [this, exchange, request](calls::Outcome outcome) {
        exchange->settle(*request, std::move(outcome));
        next(exchange);
      };
      return start(exchange, *request, jobs::ReplyOnce<calls::Outcome>{answered, internal_error()});
    }
    const auto& bad = std::get<protocol::rpc::BadRequest>(call);
    exchange->answers.push_back(protocol::json::to_text(error_response(bad.id, bad.error)));
    on_answered_({.method = "bad-request",
                  .code = static_cast<int>(bad.error.code),
                  .bytes_in = exchange->bytes,
                  .bytes_out = exchange->answers.back().size()});
  }
  std::move(exchange->reply)(exchange->text());
}

void Dispatcher::start(const std::shared_ptr<Exchange>& exchange, const protocol::rpc::Request& request,
                       jobs::ReplyOnce<calls::Outcome> reply) {
  if (request.method == kCancel) return std::move(reply)(cancel(request.params, exchange->session->id));
  const auto place = methods::runs_on(request.method);
  if (!place) {
    return std::move(reply)(protocol::rpc::RpcError{
        protocol::rpc::RpcCode::kMethodNotFound, "there is no method '" + request.method + "'", {}});
  }
  const auto call = std::make_shared<calls::OpenCall>(exchange->session, std::move(reply));
  auto time = asked_time(request.params);
  if (*place == methods::RunsOn::kStudy || *place == methods::RunsOn::kStep || *place == methods::RunsOn::kMotion) {
    time = std::min<Clock::duration>(time.value_or(longest_call_), longest_call_);
  }
  if (time) calls::OpenCall::set_deadline(call, clock_, Clock::now() + *time);
  if (request.id) calls_.add(*request.id, call);
  const bool small = exchange->bytes <= kLargeMessage;
  switch (*place) {
    case methods::RunsOn::kAtOnce:
      return call->answer(methods_.call(request.method, request.params, {*call, call->stop()}));
    case methods::RunsOn::kDrag: return drags_.take(request.method, request.params, call);
    // Retries of one call take turns, so that the later finds the answer of the earlier.
    case methods::RunsOn::kRead: {
      const bool quick = small && !methods_.large(request.params);
      return enqueue(reads_, text_field(request.params, "opId"), quick, exchange, request, call);
    }
    case methods::RunsOn::kStudy: return enqueue(reads_, {}, false, exchange, request, call);
    case methods::RunsOn::kStep: return enqueue(motions_, marker_of(request.params), small, exchange, request, call);
    case methods::RunsOn::kMotion: return enqueue(motions_, marker_of(request.params), false, exchange, request, call);
  }
}

void Dispatcher::enqueue(jobs::JobQueue& queue, std::string lane, bool quick, const std::shared_ptr<Exchange>& exchange,
                         const protocol::rpc::Request& request, const std::shared_ptr<calls::OpenCall>& call) {
  jobs::Job job{.session = exchange->session->id,
                .lane = std::move(lane),
                .quick = quick,
                .caller = call->stop(),
                .work = jobs::Work{[this, exchange, &request, call](std::stop_token stop) {
                  // Nobody waits for the outcome of a call that was cancelled before its turn came.
                  if (call->left().stop_requested() && !call->settle()) return;
                  call->answer(methods_.call(request.method, request.params, {*call, std::move(stop)}));
                }}};
  const jobs::Admission admission = queue.submit(job);
  if (admission != jobs::Admission::kAccepted) call->answer(refused(admission, queue));
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
