#include "server/dispatch/dispatcher.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/methods/daemon/engine.h"
#include "protocol/rpc/verbatim_ids.h"
#include "server/calls/errors.h"
#include "server/calls/params_checksum.h"

namespace selvage::server::dispatch {
namespace {

using protocol::calls::MethodKind;
using protocol::calls::ParsedCall;
using Duration = jobs::DeadlineClock::Duration;

constexpr std::size_t kSmallMessage = std::size_t{16} << 10;   // bytes; parsed in a fraction of a millisecond
constexpr std::size_t kLargeMessage = std::size_t{256} << 10;  // bytes; takes milliseconds and more
constexpr std::string_view kCancel = "$/cancelRequest";
constexpr const char* kBusy = "too many calls are waiting";

protocol::rpc::RpcError internal_error() {
  return {protocol::rpc::RpcCode::kInternalError, "internal error; the server's log has the details", {}};
}

// The answer to a message whose calls were lost.  Every message needs it ready and hardly any sends it.
const std::string& text_if_lost() {
  static const std::string text = error_text(internal_error());
  return text;
}

// How long the call may take: the time that it asks for, and at most the limit if its method can take long.
std::optional<Duration> time_limit(const ParsedCall& call, std::chrono::milliseconds limit) {
  std::optional<Duration> time;
  if (const auto& asked = call.about.deadline_ms) {
    time = std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>{*asked});
  }
  return call.bounded() ? std::min<Duration>(time.value_or(limit), limit) : time;
}

// Whether the marker is open and so large that writing it takes about 10 ms or more.
bool is_large(const store::MarkerStore& store, const std::string& marker_id) {
  constexpr std::size_t kManyVertices = 20'000;
  const auto summary = store.summary(marker_id);
  return summary && summary->vertices > kManyVertices;
}

// The answer to a call that is refused with this error, unless it has been cancelled.
protocol::rpc::RpcError refusal(calls::ListedCall* listed, protocol::rpc::RpcError error) {
  return listed && !listed->settle() ? calls::cancelled() : std::move(error);
}

}  // namespace

void Dispatcher::receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
                         transport::access::Reply reply) {
  jobs::ReplyOnce<std::string> once{std::move(reply), text_if_lost()};
  const jobs::DeadlineClock::Time arrived = clock_.now();
  if (message.size() <= kSmallMessage) {
    return parse(std::move(message), arrived, session, std::move(once), nullptr);
  }
  // Shared, so that the reply is still available if the queue does not accept the job.
  const auto shared_reply = std::make_shared<jobs::ReplyOnce<std::string>>(std::move(once));
  jobs::Job job{.session = session->id,
                .lane = {},
                .quick = message.size() <= kLargeMessage,
                .caller = session->gone,
                .work = jobs::Work{[this, arrived, shared_reply, session, text = std::move(message),
                                    unread = unread_.add(session->id)](auto&&) mutable {
                  parse(std::move(text), arrived, session, std::move(*shared_reply), std::move(unread));
                }}};
  const jobs::Admission admission = queues_.parsing.submit(job);
  if (admission == jobs::Admission::kAccepted) return;
  std::move (*shared_reply)(error_text(calls::not_admitted(admission, queues_.parsing, kBusy)));
}

std::string Dispatcher::too_long(std::size_t limit) {
  return error_text({protocol::rpc::RpcCode::kTooLarge,
                     "the message is longer than " + std::to_string(limit) + " bytes", Json{{"limit", limit}}});
}

void Dispatcher::parse(std::string message, jobs::DeadlineClock::Time arrived,
                       std::shared_ptr<transport::access::Session> session, jobs::ReplyOnce<std::string> reply,
                       std::shared_ptr<const UnreadMessages::Ticket> unread) {
  const std::size_t bytes = message.size();
  protocol::rpc::Incoming incoming = protocol::rpc::parse_incoming(message, server_.limits.transport.body_bytes);
  std::vector<std::string> ids;
  if (has_inexact_ids(incoming)) ids = verbatim_ids(message, incoming);
  std::string{}.swap(message);  // frees it now, because it may be large
  std::vector<std::shared_ptr<calls::ListedCall>> listed;
  for (const protocol::rpc::Call& call : incoming.calls) {
    const auto* const request = std::get_if<protocol::rpc::Request>(&call);
    const bool has_id = request && request->id;
    listed.push_back(has_id ? calls_.expect(*request->id, session->id) : nullptr);
  }
  unread.reset();
  execute_next(std::make_shared<Exchange>(Exchange{.freed = ops::FreedMemory{bytes},
                                                   .incoming = std::move(incoming),
                                                   .bytes = bytes,
                                                   .session = std::move(session),
                                                   .reply = std::move(reply),
                                                   .on_answered = on_answered_,
                                                   .arrived = arrived,
                                                   .ids = std::move(ids),
                                                   .listed = std::move(listed)}));
}

void Dispatcher::execute_next(const std::shared_ptr<Exchange>& exchange) {
  const std::vector<protocol::rpc::Call>& calls = exchange->incoming.calls;
  const bool elsewhere = std::exchange(exchange->continue_on_worker, false) && exchange->calls_done < calls.size();
  if (elsewhere && execute_next_on_worker(exchange)) return;
  while (exchange->calls_done < calls.size()) {
    const protocol::rpc::Call& call = calls[exchange->calls_done++];
    if (const auto* request = std::get_if<protocol::rpc::Request>(&call)) {
      exchange->marker_id.clear();
      exchange->only_read = false;
      const std::size_t most_bytes = server_.limits.transport.backlog_bytes;
      if (exchange->is_full(most_bytes)) {
        exchange->add_answer(*request, refusal(exchange->take_listed().get(), no_room_for_answer(most_bytes)));
        continue;
      }
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

bool Dispatcher::execute_next_on_worker(const std::shared_ptr<Exchange>& exchange) {
  jobs::Job job{.session = exchange->session->id,
                .lane = {},
                .quick = exchange->bytes <= kLargeMessage,
                .caller = {},
                .work = jobs::Work{[this, exchange](auto&&) { execute_next(exchange); }}};
  return queues_.parsing.submit(job) == jobs::Admission::kAccepted;
}

void Dispatcher::start(const std::shared_ptr<Exchange>& exchange, const protocol::rpc::Request& request,
                       jobs::ReplyOnce<calls::Outcome> reply) {
  std::shared_ptr<calls::ListedCall> listed = exchange->take_listed();
  const auto refuse = [&](protocol::rpc::RpcError error) { std::move(reply)(refusal(listed.get(), std::move(error))); };
  // Before its parameters are decoded, which may take long.
  if (listed && listed->cancelled()) return refuse(calls::cancelled());
  if (request.method == kCancel) {
    if (listed && !listed->settle()) return std::move(reply)(calls::cancelled());
    return cancel(request.params, exchange->session->id, std::move(reply));
  }
  const auto* row = server_.methods.find(request.method);
  if (!row) return refuse(protocol::calls::unknown_method(request.method));
  auto parsed = row->method.read(request.params);
  if (!parsed) return refuse(protocol::rpc::rpc_error(parsed.error()));

  exchange->marker_id = parsed->about.marker_id;
  const std::int64_t sum = parsed->about.op_id ? calls::params_checksum(request.params) : 0;
  const auto call = std::make_shared<calls::OpenCall>(exchange->session, std::move(reply), sum);
  if (listed && !calls::ListedCall::begin(std::move(listed), call)) {
    call->cancel();
    return;
  }
  schedule(*std::move(parsed), *row, exchange, call);
}

void Dispatcher::set_deadline(const std::shared_ptr<Exchange>& exchange, const std::shared_ptr<calls::OpenCall>& call,
                              jobs::JobQueue& queue, jobs::DeadlineClock::Time time) {
  const auto if_waiting = [exchange, &queue] {
    exchange->continue_on_worker = true;
    queue.remove_answered();
    return calls::not_begun(queue);
  };
  calls::OpenCall::set_deadline(call, clock_, time, if_waiting);
}

void Dispatcher::schedule(ParsedCall parsed, const methods::HandlerTable::Row& row,
                          const std::shared_ptr<Exchange>& exchange, const std::shared_ptr<calls::OpenCall>& call) {
  const MethodKind kind = parsed.kind;
  const bool unread = server_.store.is_unread(parsed.about.marker_id);
  // Drag sessions have their own queue.
  if (!unread && (kind == MethodKind::kImmediate || kind == MethodKind::kDrag)) {
    return row.handle(std::move(parsed), server_, call);
  }
  const bool uses_file = row.file_use != methods::FileUse::kNone;
  const bool is_search = kind == MethodKind::kSearch;
  exchange->only_read = (kind == MethodKind::kRead || kind == MethodKind::kAnalysis || is_search) && !uses_file;
  // A call in a batch with large answers does not count as quick, because such answers take long to write and to join.
  const bool small = exchange->bytes <= kLargeMessage && exchange->held.bytes() <= kLargeMessage &&
                     row.file_use != methods::FileUse::kCopies;
  const bool quick = small && (kind == MethodKind::kStep || (kind == MethodKind::kRead && !unread &&
                                                             !is_large(server_.store, parsed.about.marker_id)));
  const bool is_motion = kind == MethodKind::kStep || kind == MethodKind::kMotion || is_search;
  jobs::JobQueue& queue = is_motion ? queues_.motions : uses_file ? queues_.openings : queues_.reads;
  std::string lane = parsed.lane();
  std::optional<jobs::DeadlineClock::Time> deadline;
  if (const auto time = time_limit(parsed, server_.limits.call)) {
    // A call in a batch counts as arriving when its turn in the batch comes.
    deadline = (exchange->incoming.batch ? clock_.now() : exchange->arrived) + *time;
    set_deadline(exchange, call, queue, *deadline);
  }
  jobs::Job job{
      .session = exchange->session->id,
      .lane = std::move(lane),
      .quick = quick,
      .deadline = deadline,
      .caller = call->stop(),
      .work = jobs::Work{[this, exchange, &row, held = std::move(parsed), call](const std::stop_token& stop) mutable {
        if (!call->begin()) return;  // it was cancelled, or refused at its deadline
        const std::stop_callback on_drain{stop, [&call] { call->drain(); }};
        row.handle(std::move(held), server_, call);
      }},
      .ending = call->ending()};
  const jobs::Admission admission = queue.submit(job);
  if (admission != jobs::Admission::kAccepted) call->answer(calls::not_admitted(admission, queue, kBusy));
}

void Dispatcher::cancel(const Json& params, std::uint64_t session, jobs::ReplyOnce<calls::Outcome> reply) {
  const auto decoded = protocol::schema::decode<protocol::methods::daemon::CancelParams>(params);
  if (!decoded) return std::move(reply)(protocol::rpc::rpc_error(decoded.error()));
  // Shared, because a function that waits must be copyable, and because the reply is still needed if none waits.
  const auto shared_reply = std::make_shared<jobs::ReplyOnce<calls::Outcome>>(std::move(reply));
  const auto answer = [shared_reply](bool cancelled) {
    std::move (*shared_reply)(protocol::schema::encode(protocol::methods::daemon::CancelResult{cancelled}));
  };
  const Json id = decoded->id.value;
  if (cancel_now(id, session)) return answer(true);
  // The call may be in a message that was received before this one and has not been read yet.
  if (unread_.when_read(session, [this, id, session, answer] { answer(cancel_now(id, session)); })) return;
  // It may have been read since.
  answer(cancel_now(id, session));
}

bool Dispatcher::cancel_now(const Json& id, std::uint64_t session) {
  const bool cancelled = calls_.cancel(id, session);
  if (cancelled) queues_.remove_answered();
  return cancelled;
}

}  // namespace selvage::server::dispatch
