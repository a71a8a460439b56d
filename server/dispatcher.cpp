#include "server/dispatcher.h"

#include <chrono>
#include <utility>
#include <vector>

#include "server/log.h"

namespace selvage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSmallMessage = std::size_t{16} << 10;  // bytes; parsed in a fraction of a millisecond
constexpr int kRetryAfterMs = 200;

RpcError internal_error() {
  return {RpcCode::kInternalError, "the server failed; its log says why", {}};
}

RpcError refused(Admission admission) {
  if (admission == Admission::kDraining) return {RpcCode::kDraining, "the server is going down", {}};
  return {RpcCode::kBusy, "too many calls are waiting", Json{{"retryAfterMs", kRetryAfterMs}}};
}

std::string text_of(const RpcError& error) {
  return to_text(error_response(nullptr, error));
}

// The marker a call is about: of its params, or of the answer that opened it.  Empty: none.
std::string marker_of(const Json& fields) {
  const auto found = fields.is_object() ? fields.find("markerId") : fields.end();
  return found != fields.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

}  // namespace

struct Dispatcher::Exchange {
  Incoming incoming;
  std::size_t bytes{};
  std::stop_token caller;
  ReplyOnce<std::string> reply;
  Clock::time_point began{Clock::now()};
  std::size_t calls_done{};
  std::vector<std::string> answers{};

  // The answer to the call that is under way.
  void settle(const Request& request, Outcome outcome) {
    AnsweredRequest line{.method = request.method, .marker = marker_of(request.params), .bytes_in = bytes};
    line.milliseconds = std::chrono::duration<double, std::milli>{Clock::now() - began}.count();
    if (const auto* error = std::get_if<RpcError>(&outcome)) {
      line.code = static_cast<int>(error->code);
    } else if (line.marker.empty()) {
      line.marker = marker_of(std::get<Json>(outcome));
    }
    if (request.id) {
      answers.push_back(answer_text(*request.id, std::move(outcome)));
      line.bytes_out = answers.back().size();
    }
    log_request(line);
  }

  static std::string answer_text(const Json& id, Outcome outcome) {
    if (const auto* error = std::get_if<RpcError>(&outcome)) return to_text(error_response(id, *error));
    return to_text(response(id, std::get<Json>(std::move(outcome))));
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

void Dispatcher::receive(std::string message, std::stop_token caller, Reply reply) {
  ReplyOnce<std::string> once{std::move(reply), text_of(internal_error())};
  if (message.size() <= kSmallMessage) return take_apart(message, std::move(caller), std::move(once));
  // Shared, so that the reply is still at hand when the queue refuses.
  const auto held = std::make_shared<ReplyOnce<std::string>>(std::move(once));
  Job job{.lane = {}, .caller = caller, .work = Work{[this, held, caller, text = std::move(message)](auto&&) {
                                          take_apart(text, caller, std::move(*held));
                                        }}};
  const Admission admission = reads_.submit(job);
  if (admission != Admission::kAccepted) std::move (*held)(text_of(refused(admission)));
}

std::string Dispatcher::too_long(std::size_t limit) {
  return text_of(
      {RpcCode::kTooLarge, "the message is longer than " + std::to_string(limit) + " bytes", Json{{"limit", limit}}});
}

void Dispatcher::take_apart(std::string_view message, std::stop_token caller, ReplyOnce<std::string> reply) {
  next(std::make_shared<Exchange>(Exchange{.incoming = parse_incoming(message, max_bytes_),
                                           .bytes = message.size(),
                                           .caller = std::move(caller),
                                           .reply = std::move(reply)}));
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
    log_request({.method = "bad-request",
                 .code = static_cast<int>(bad.error.code),
                 .bytes_in = exchange->bytes,
                 .bytes_out = exchange->answers.back().size()});
  }
  std::move(exchange->reply)(exchange->text());
}

void Dispatcher::start(const std::shared_ptr<Exchange>& exchange, const Request& request, ReplyOnce<Outcome> reply) {
  const auto place = place_of(request.method);
  if (!place) {
    return std::move(reply)(RpcError{RpcCode::kMethodNotFound, "there is no method '" + request.method + "'", {}});
  }
  if (*place == Place::kAtOnce) {
    return std::move(reply)(methods_.call(request.method, request.params, {exchange->caller, exchange->caller}));
  }
  const bool motion = *place == Place::kMotion;
  const auto held = std::make_shared<ReplyOnce<Outcome>>(std::move(reply));
  Job job{.lane = motion ? marker_of(request.params) : std::string{},
          .caller = exchange->caller,
          .work = Work{[this, exchange, &request, held](std::stop_token stop) {
            std::move (*held)(methods_.call(request.method, request.params, {std::move(stop), exchange->caller}));
          }}};
  const Admission admission = (motion ? motions_ : reads_).submit(job);
  if (admission != Admission::kAccepted) std::move (*held)(refused(admission));
}

}  // namespace selvage
