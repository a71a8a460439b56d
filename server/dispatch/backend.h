// Everything behind the transport: messages in, answers out.  Owns the markers, the queues and the methods, and ends
// them in the right order.
#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <string>

#include "core/minkowski/cache.h"
#include "protocol/execution/thread_pool.h"
#include "protocol/methods/method_table.h"
#include "server/calls/limits.h"
#include "server/changes/committer.h"
#include "server/changes/connection_markers.h"
#include "server/changes/watchers.h"
#include "server/dispatch/dispatcher.h"
#include "server/dispatch/work_queues.h"
#include "server/drags/drag_sessions.h"
#include "server/jobs/deadline_clock.h"
#include "server/library/library.h"
#include "server/methods/context.h"
#include "server/methods/handler_table.h"
#include "server/store/journal.h"
#include "server/store/marker_store.h"

namespace selvage::server::dispatch {

struct BackendSettings {
  std::size_t workers{};                          // for motions; 0: everything is executed inline
  std::size_t cache_bytes{std::size_t{1} << 20};  // for Minkowski sums
  calls::Limits limits{};
  store::Journal* journal{};  // null: markers live in memory only
  std::stop_token loading{};  // ends the reading of the journal, with an exception
  protocol::methods::MethodTable methods = protocol::methods::method_table();
  drags::DragFunction drag = drags::drag_function();
  ops::OnAnswered on_answered = ops::log_request;
};

class Backend {
 public:
  explicit Backend(BackendSettings settings);
  ~Backend();  // drains
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;

  // Same as Dispatcher::receive.
  void receive(std::string message, const std::shared_ptr<transport::access::Session>& session,
               transport::access::Reply reply) {
    dispatcher_.receive(std::move(message), session, std::move(reply));
  }

  [[nodiscard]] WorkQueues& queues() { return queues_; }
  [[nodiscard]] const WorkQueues& queues() const { return queues_; }
  [[nodiscard]] jobs::DeadlineClock& clock() { return clock_; }
  [[nodiscard]] const SumCache& sums() const { return sums_; }
  [[nodiscard]] const store::MarkerStore& store() const { return store_; }
  [[nodiscard]] const drags::DragSessions& drags() const { return drags_; }
  [[nodiscard]] std::size_t open_calls() const { return dispatcher_.open_calls(); }
  // The reason why no work should be sent to this server now; empty if there is none.
  [[nodiscard]] std::string why_not_ready() const;

 private:
  // How many of this number of cores no job is using now.
  [[nodiscard]] std::size_t idle_cores(std::size_t cores) const;

  const calls::Limits limits_;
  SumCache sums_;
  store::MarkerStore store_;
  library::Library library_;
  changes::Watchers watchers_;
  changes::Committer committer_{store_, watchers_};
  const methods::HandlerTable methods_;
  protocol::execution::ThreadPool executor_;
  jobs::DeadlineClock clock_;
  WorkQueues queues_;
  drags::DragSessions drags_;
  changes::ConnectionMarkers connection_markers_{store_, watchers_, queues_.openings};
  const methods::ServerContext context_;
  Dispatcher dispatcher_;
};

}  // namespace selvage::server::dispatch
