// Answers the calls of the protocol in this process, as a daemon with a single client would.
//
// All methods that open, read, change and close markers are available.  Watching, drag sessions and the operator's
// methods need a daemon.  An `opId` has no effect, because no call can be lost and sent again, and neither has
// `closeWithConnection`: all markers are closed when the engine ends, which is its only connection.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "clients/engine/calls.h"
#include "protocol/execution/thread_pool.h"

namespace selvage::engine {

class Engine {
 public:
  // `threads`: how many threads a motion may use, at least 1.  Their number does not change the answers.
  explicit Engine(std::size_t threads) : threads_{threads}, pool_{threads - 1} {}

  // Returns the response to a JSON-RPC request: the same bytes as a daemon's, except for engine.info and for the times
  // requested by `timing`.  The response to a request without an id is empty.  May be called from any thread; changes
  // of the same marker run one after another.
  [[nodiscard]] std::string answer(std::string_view request, const Caller& caller);

 private:
  const std::size_t threads_;
  const protocol::execution::ThreadPool pool_;
  SumCache sums_;
  OpenMarkers markers_;
};

}  // namespace selvage::engine
