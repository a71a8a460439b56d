#include "server/dispatcher.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/call_fields.h"
#include "server/freed_memory.h"
#include "server/refusals.h"

namespace selvage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSmallMessage = std::size_t{16} << 10;   // bytes; parsed in a fraction of a millisecond
constexpr std::size_t kLargeMessage = std::size_t{256} << 10;  // bytes; takes milliseconds and more
constexpr std::string_view kCancel = "$/cancelRequest";

RpcError internal_error() {
  return {RpcCode::kInternalError, "the server failed; its log says why", {}};
}

RpcError refused(Admission admission, const JobQueue& queue) {
  if (admission == Admission::kDraining) return going_down();
  return {RpcCode::kBusy, "too many calls are waiting", Json{{"retryAfterMs", queue.retry_after_ms()}}};
}

std::string text_of(const RpcError& error) {
  return to_text(error_response(nullptr, error));
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
  if (!(milliseconds >= kDeadlines.least && milliseconds <= kDeadlines.most)) return std::nullopt;
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>{milliseconds});
}

}  // namespace

struct Dispatcher::Exchange {
  FreedMemory freed;  // first: goes when all the rest has gone
  Incoming incoming;
  std::size_t bytes{};
  std::shared_ptr<Session> session;
  ReplyOnce<std::string> reply;
  const OnAnswered& on_answered;
  Clock::time_point began{Clock::now()};
  std::size_t calls_done{};
  std::vector<std::string> answers{};

  // The answer to the call that is under way.
  void settle(const Request& request, Outcome outcome) {
    AnsweredRequest line{.method = request.method, .marker = marker_of(request.params), .bytes_in = bytes};
    line.milliseconds = std::chrono::duration<double, std::milli>{Clock::now() - began}.count();
    if (const auto* error = std::get_if<RpcError>(&outcome)) {
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

  static std::string answer_text(const Json& id, Outcome outcome) {
    if (const auto* error = std::get_if<RpcError>(&outcome)) return to_text(error_response(id, *error));
    if (auto* result = std::get_if<Json>(&outcome)) return to_text(response(id, std::move(*result)));
    return response_text(id, *std::get<SharedText>(outcome));
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

void Dispatcher::receive(std::string message, const std::shared_ptr<Session>& session, Reply reply) {
  ReplyOnce<std::string> once{std::move(reply), text_of(internal_error())};
  if (message.size() <= kSmallMessage) return take_apart(std::move(message), session, std::move(once));
  JobQueue& queue = message.size() <= kLargeMessage ? reads_ : parsing_;
  // Shared, so that the reply is still at hand when the queue refuses.
  const auto held = std::make_shared<ReplyOnce<std::string>>(std::move(once));
  Job job{.session = session->id,
          .lane = {},
          .quick = true,
          .caller = session->gone,
          .work = Work{[this, held, session, text = std::move(message)](auto&&) mutable {
            take_apart(std::move(text), session, std::move(*held));
          }}};
  const Admission admission = queue.submit(job);
  if (admission != Admission::kAccepted) std::move (*held)(text_of(refused(admission, queue)));
}

std::string Dispatcher::too_long(std::size_t limit) {
  return text_of(
      {RpcCode::kTooLarge, "the message is longer than " + std::to_string(limit) + " bytes", Json{{"limit", limit}}});
}

void Dispatcher::take_apart(std::string message, std::shared_ptr<Session> session, ReplyOnce<std::string> reply) {
  const std::size_t bytes = message.size();
  Incoming incoming = parse_incoming(message, longest_message_);
  std::string{}.swap(message);  // has served; it may be large
  next(std::make_shared<Exchange>(Exchange{.freed = FreedMemory{bytes},
                                           .incoming = std::move(incoming),
                                           .bytes = bytes,
                                           .session = std::move(session),
                                           .reply = std::move(reply),
                                           .on_answered = on_answered_}));
}

void Dispatcher::next(const std::shared_ptr<Exchange>& exchange) {
  const std::vector<Call>& calls = exchange->incoming.calls;
  while (exchange->calls_done < calls.size()) {
    const Call& call = calls[exchange->calls_done++];
    if (const auto* request = std::get_if<Request>(&call)) {
      const auto answered = [this, exchange, request](Outcome outcome) {
        exchange->settle(*request, std::move(outcome));
        next(exchange);
      };
      return start(exchange, *request, ReplyOnce<Outcome>{answered, internal_error()});
    }
    const auto& bad = std::get<BadRequest>(call);
    exchange->answers.push_back(to_text(error_response(bad.id, bad.error)));
    on_answered_({.method = "bad-request",
                  .code = static_cast<int>(bad.error.code),
                  .bytes_in = exchange->bytes,
                  .bytes_out = exchange->answers.back().size()});
  }
  std::move(exchange->reply)(exchange->text());
}

void Dispatcher::start(const std::shared_ptr<Exchange>& exchange, const Request& request, ReplyOnce<Outcome> reply) {
  if (request.method == kCancel) return std::move(reply)(cancel(request.params, exchange->session->id));
  const auto place = place_of(request.method);
  if (!place) {
    return std::move(reply)(RpcError{RpcCode::kMethodNotFound, "there is no method '" + request.method + "'", {}});
  }
  const auto call = std::make_shared<OpenCall>(exchange->session, std::move(reply));
  auto time = asked_time(request.params);
  if (*place == Place::kStudy || *place == Place::kStep || *place == Place::kMotion) {
    time = std::min<Clock::duration>(time.value_or(longest_call_), longest_call_);
  }
  if (time) OpenCall::set_deadline(call, clock_, Clock::now() + *time);
  if (request.id) calls_.add(*request.id, call);
  const bool small = exchange->bytes <= kLargeMessage;
  switch (*place) {
    case Place::kAtOnce: return call->answer(methods_.call(request.method, request.params, {*call, call->stop()}));
    case Place::kDrag: return drags_.take(request.method, request.params, call);
    // Retries of one call take turns, so that the later finds the answer of the earlier.
    case Place::kRead: {
      const bool quick = small && !methods_.large(request.params);
      return enqueue(reads_, text_field(request.params, "opId"), quick, exchange, request, call);
    }
    case Place::kStudy: return enqueue(reads_, {}, false, exchange, request, call);
    case Place::kStep: return enqueue(motions_, marker_of(request.params), small, exchange, request, call);
    case Place::kMotion: return enqueue(motions_, marker_of(request.params), false, exchange, request, call);
  }
}

void Dispatcher::enqueue(JobQueue& queue, std::string lane, bool quick, const std::shared_ptr<Exchange>& exchange,
                         const Request& request, const std::shared_ptr<OpenCall>& call) {
  Job job{.session = exchange->session->id,
          .lane = std::move(lane),
          .quick = quick,
          .caller = call->stop(),
          .work = Work{[this, exchange, &request, call](std::stop_token stop) {
            // Nobody waits for the outcome of a call that was cancelled before its turn came.
            if (call->left().stop_requested() && !call->settle()) return;
            call->answer(methods_.call(request.method, request.params, {*call, std::move(stop)}));
          }}};
  const Admission admission = queue.submit(job);
  if (admission != Admission::kAccepted) call->answer(refused(admission, queue));
}

Outcome Dispatcher::cancel(const Json& params, std::uint64_t session) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  const Json* id = fields.maybe_any("id");
  fields.finish();
  if (!id) mistake.add(ErrorCode::kMissingField, "the field is missing; it is required", "/id");
  if (mistake) return rpc_error(mistake.error());
  return Json{{"cancelled", calls_.cancel(*id, session)}};
}

}  // namespace selvage
