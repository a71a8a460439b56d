// From a message to its answer: parses JSON-RPC, finds each call's method, decodes its parameters once, schedules it
// and makes sure that it is answered exactly once.
//
// Small messages are parsed on the calling thread, larger ones on a worker.  The calls of a batch are executed one
// after another, in order; one that fails does not stop those that follow.  A call can be cancelled as soon as its
// message has been received: a request to cancel it waits until the messages received before have been read.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "server/calls/open_call.h"
#include "server/calls/open_calls.h"
#include "server/dispatch/exchange.h"
#include "server/dispatch/unread_messages.h"
#include "server/dispatch/work_queues.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/reply_once.h"
#include "server/methods/context.h"
#include "server/methods/handler_table.h"
#include "server/ops/log.h"
#include "server/transport/access/service.h"

namespace selvage::server::dispatch {

class Dispatcher {
 public:
  // REQUIRES: all references outlive the dispatcher and every call.
  Dispatcher(const methods::ServerContext& server, jobs::DeadlineClock& clock, WorkQueues& queues,
             ops::OnAnswered on_answered = ops::log_request)
      : server_{server}, clock_{clock}, queues_{queues}, on_answered_{std::move(on_answered)} {}

  // Never blocks, unless the queues have no workers.
  void receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
               transport::access::Reply reply);
  // The answer to a message that was not read because it exceeds the length limit.
  [[nodiscard]] static std::string too_long(std::size_t limit);
  // Calls in progress that have an id.
  [[nodiscard]] std::size_t open_calls() const { return calls_.count(); }

 private:
  // `unread`: of the message; null if no other message can arrive before it has been read.
  void parse(std::string message, jobs::DeadlineClock::Time arrived,
             std::shared_ptr<transport::access::Session> session, jobs::ReplyOnce<std::string> reply,
             std::shared_ptr<const UnreadMessages::Ticket> unread);
  void execute_next(const std::shared_ptr<Exchange>& exchange);
  // Returns false if no worker accepts it.
  [[nodiscard]] bool execute_next_on_worker(const std::shared_ptr<Exchange>& exchange);
  void start(const std::shared_ptr<Exchange>& exchange, const protocol::rpc::Request& request,
             jobs::ReplyOnce<calls::Outcome> reply);
  void set_deadline(const std::shared_ptr<Exchange>& exchange, const std::shared_ptr<calls::OpenCall>& call,
                    jobs::JobQueue& queue, jobs::DeadlineClock::Time time);
  void schedule(protocol::calls::ParsedCall parsed, const methods::HandlerTable::Row& row,
                const std::shared_ptr<Exchange>& exchange, const std::shared_ptr<calls::OpenCall>& call);
  void cancel(const Json& params, std::uint64_t session, jobs::ReplyOnce<calls::Outcome> reply);
  [[nodiscard]] bool cancel_now(const Json& id, std::uint64_t session);

  const methods::ServerContext& server_;
  jobs::DeadlineClock& clock_;
  WorkQueues& queues_;
  const ops::OnAnswered on_answered_;
  calls::OpenCalls calls_;
  UnreadMessages unread_;
};

}  // namespace selvage::server::dispatch
