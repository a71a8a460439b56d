// From a message to its answer: takes JSON-RPC apart, finds the method, runs it where it belongs and makes
// sure that every call is answered exactly once.
//
// Small messages are parsed on the calling thread, large ones on a worker for reads.  The calls of a batch
// run one after another, in order; one that fails does not stop those behind it.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "server/calls/limits.h"
#include "server/calls/open_call.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/job_queue.h"
#include "server/jobs/reply_once.h"
#include "server/methods/drags.h"
#include "server/methods/methods.h"
#include "server/ops/log.h"
#include "server/transport/access/service.h"

namespace selvage::server::dispatch {

class Dispatcher {
 public:
  // REQUIRES: all outlive the dispatcher and every call.
  Dispatcher(methods::Methods& methods, methods::Drags& drags, jobs::DeadlineClock& clock, jobs::JobQueue& parsing,
             jobs::JobQueue& reads, jobs::JobQueue& motions, const calls::Limits& limits,
             ops::OnAnswered on_answered = ops::log_request)
      : methods_{methods},
        drags_{drags},
        clock_{clock},
        parsing_{parsing},
        reads_{reads},
        motions_{motions},
        longest_message_{limits.transport.body_bytes},
        longest_call_{limits.call},
        on_answered_{std::move(on_answered)} {}

  // Never blocks, unless the queues have no workers.
  void receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
               transport::access::Reply reply);
  // The answer to a message that is longer than the limit and was therefore not read.
  [[nodiscard]] static std::string too_long(std::size_t limit);
  // Calls that have an id and are not done with.
  [[nodiscard]] std::size_t open_calls() const { return calls_.count(); }

 private:
  struct Exchange;  // one message on its way
  void take_apart(std::string message, std::shared_ptr<transport::access::Session> session,
                  jobs::ReplyOnce<std::string> reply);
  void next(const std::shared_ptr<Exchange>& exchange);
  void start(const std::shared_ptr<Exchange>& exchange, const protocol::rpc::Request& request,
             jobs::ReplyOnce<calls::Outcome> reply);
  void enqueue(jobs::JobQueue& queue, std::string lane, bool quick, const std::shared_ptr<Exchange>& exchange,
               const protocol::rpc::Request& request, const std::shared_ptr<calls::OpenCall>& call);
  [[nodiscard]] calls::Outcome cancel(const Json& params, std::uint64_t session);

  methods::Methods& methods_;
  methods::Drags& drags_;
  jobs::DeadlineClock& clock_;
  jobs::JobQueue& parsing_;  // of large messages: no read waits behind one
  jobs::JobQueue& reads_;
  jobs::JobQueue& motions_;
  const std::size_t longest_message_;  // bytes
  const std::chrono::milliseconds longest_call_;
  const ops::OnAnswered on_answered_;
  calls::OpenCalls calls_;
};

}  // namespace selvage::server::dispatch
