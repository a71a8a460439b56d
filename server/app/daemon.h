// The daemon: every part of it, put together, and the order in which they end.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "protocol/calls/engine.h"
#include "protocol/execution/thread_pool.h"
#include "server/app/options.h"
#include "server/dispatch/dispatcher.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/job_queue.h"
#include "server/methods/drags.h"
#include "server/methods/methods.h"
#include "server/methods/watchers.h"
#include "server/ops/metrics.h"
#include "server/store/journal.h"
#include "server/store/marker_store.h"
#include "server/transport/transport.h"

namespace selvage::server::app {

class Daemon {
 public:
  // Serves at once; a replay only calls.  Throws when an address cannot be taken or a file not be used.
  explicit Daemon(const Options& options, protocol::calls::Engine engine = {});
  ~Daemon();  // drains
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // Where it listens, HTTP first.  REQUIRES of port(): it listens.
  [[nodiscard]] const std::vector<transport::access::Listener>& listeners() const { return transport_.listeners(); }
  [[nodiscard]] std::uint16_t port() const { return listeners().front().port; }
  [[nodiscard]] const SumCache& sums() const { return sums_; }

  // Takes nothing new, asks what runs to hand back its best, sends every answer, closes.
  void drain();

  // Answers a message that came by no socket.
  void call(std::string message, const std::shared_ptr<transport::access::Session>& session,
            transport::access::Reply reply);
  // GET /readyz and /metrics.
  [[nodiscard]] std::string why_not_ready() const;
  [[nodiscard]] std::string metrics_text() const;

 private:
  [[nodiscard]] transport::access::Service service(const Options& options);
  // Of so many cores, those that no job is on now.
  [[nodiscard]] std::size_t idle_cores(std::size_t cores) const;

  const std::chrono::seconds drain_patience_;
  std::atomic<bool> draining_{};
  ops::Metrics metrics_;
  const std::shared_ptr<transport::access::TransportCounts> connections_ =
      std::make_shared<transport::access::TransportCounts>();
  SumCache sums_;
  std::unique_ptr<store::Journal> journal_;  // null: markers live in memory only
  store::MarkerStore store_;
  methods::Watchers watchers_;
  protocol::execution::ThreadPool executor_;
  methods::Methods methods_;
  jobs::DeadlineClock clock_;
  jobs::JobQueue parsing_;
  jobs::JobQueue reads_;
  jobs::JobQueue motions_;
  jobs::JobQueue hands_;
  methods::Drags drags_;
  dispatch::Dispatcher dispatcher_;
  transport::Transport transport_;
};

}  // namespace selvage::server::app
