// The methods of the protocol in this process: what a daemon answers to its only client, without a daemon.
//
// Served: everything that opens, reads, changes and closes markers.  Watching, drag sessions and the operator's methods
// need a daemon.  An `opId` has no effect: no call is lost on the way and sent again.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "clients/engine/calls.h"
#include "protocol/execution/thread_pool.h"

namespace selvage::engine {

class Engine {
 public:
  // `threads`: that a motion may use, at least 1.  They do not change the answers.
  explicit Engine(std::size_t threads) : threads_{threads}, pool_{threads - 1} {}

  // A JSON-RPC request in, its response out: the bytes that a daemon answers, but for engine.info and for the times
  // that `timing` asks for.  Empty for a request without an id.  May be called from any thread; the changes of one
  // marker run one after another.
  [[nodiscard]] std::string answer(std::string_view request, const Caller& caller);

 private:
  const std::size_t threads_;
  const protocol::execution::ThreadPool pool_;
  SumCache sums_;
  OpenMarkers markers_;
};

}  // namespace selvage::engine
