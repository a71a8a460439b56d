// From a message to its answer: takes JSON-RPC apart, finds the method, runs it where it belongs and makes
// sure that every call is answered exactly once.
//
// Small messages are parsed on the calling thread, large ones on a worker for reads.  The calls of a batch
// run one after another, in order; one that fails does not stop those behind it.
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <string>

#include "server/job_queue.h"
#include "server/methods.h"
#include "server/reply_once.h"
#include "server/transport/service.h"

namespace selvage {

class Dispatcher {
 public:
  // REQUIRES: all outlive the dispatcher and every call.
  Dispatcher(Methods& methods, JobQueue& reads, JobQueue& motions, std::size_t max_bytes)
      : methods_{methods}, reads_{reads}, motions_{motions}, max_bytes_{max_bytes} {}

  // Never blocks, unless the queues have no workers.  `caller` stops when nobody waits for the answer any
  // more.
  void receive(std::string message, std::stop_token caller, Reply reply);
  // The answer to a message that is longer than the limit and was therefore not read.
  [[nodiscard]] static std::string too_long(std::size_t limit);

 private:
  struct Exchange;  // one message on its way
  void take_apart(std::string_view message, std::stop_token caller, ReplyOnce<std::string> reply);
  void next(const std::shared_ptr<Exchange>& exchange);
  void start(const std::shared_ptr<Exchange>& exchange, const Request& request, ReplyOnce<Outcome> reply);

  Methods& methods_;
  JobQueue& reads_;
  JobQueue& motions_;
  const std::size_t max_bytes_;
};

}  // namespace selvage
