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

#include "server/deadline_clock.h"
#include "server/drags.h"
#include "server/job_queue.h"
#include "server/limits.h"
#include "server/log.h"
#include "server/methods.h"
#include "server/open_call.h"
#include "server/reply_once.h"
#include "server/transport/service.h"

namespace selvage {

class Dispatcher {
 public:
  // REQUIRES: all outlive the dispatcher and every call.
  Dispatcher(Methods& methods, Drags& drags, DeadlineClock& clock, JobQueue& parsing, JobQueue& reads,
             JobQueue& motions, const Limits& limits, OnAnswered on_answered = log_request)
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
  void receive(std::string message, const std::shared_ptr<Session>& session, Reply reply);
  // The answer to a message that is longer than the limit and was therefore not read.
  [[nodiscard]] static std::string too_long(std::size_t limit);
  // Calls that have an id and are not done with.
  [[nodiscard]] std::size_t open_calls() const { return calls_.count(); }

 private:
  struct Exchange;  // one message on its way
  void take_apart(std::string message, std::shared_ptr<Session> session, ReplyOnce<std::string> reply);
  void next(const std::shared_ptr<Exchange>& exchange);
  void start(const std::shared_ptr<Exchange>& exchange, const Request& request, ReplyOnce<Outcome> reply);
  void enqueue(JobQueue& queue, std::string lane, bool quick, const std::shared_ptr<Exchange>& exchange,
               const Request& request, const std::shared_ptr<OpenCall>& call);
  [[nodiscard]] Outcome cancel(const Json& params, std::uint64_t session);

  Methods& methods_;
  Drags& drags_;
  DeadlineClock& clock_;
  JobQueue& parsing_;  // of large messages: no read waits behind one
  JobQueue& reads_;
  JobQueue& motions_;
  const std::size_t longest_message_;  // bytes
  const std::chrono::milliseconds longest_call_;
  const OnAnswered on_answered_;
  OpenCalls calls_;
};

}  // namespace selvage
