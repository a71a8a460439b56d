// The daemon: every part of it, put together, and the order in which they end.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "protocol/engine.h"
#include "server/crew/thread_crew.h"
#include "server/deadline_clock.h"
#include "server/dispatcher.h"
#include "server/drags.h"
#include "server/job_queue.h"
#include "server/journal.h"
#include "server/marker_store.h"
#include "server/methods.h"
#include "server/metrics.h"
#include "server/options.h"
#include "server/transport/transport.h"
#include "server/watchers.h"

namespace selvage {

class Daemon {
 public:
  // Serves at once; a replay only calls.  Throws when an address cannot be taken or a file not be used.
  explicit Daemon(const Options& options, Engine engine = {});
  ~Daemon();  // drains
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // Where it listens, HTTP first.  REQUIRES of port(): it listens.
  [[nodiscard]] const std::vector<Listener>& listeners() const { return transport_.listeners(); }
  [[nodiscard]] std::uint16_t port() const { return listeners().front().port; }
  [[nodiscard]] const SumCache& sums() const { return sums_; }

  // Takes nothing new, asks what runs to hand back its best, sends every answer, closes.
  void drain();

  // Answers a message that came by no socket.
  void call(std::string message, const std::shared_ptr<Session>& session, Reply reply);
  // GET /readyz and /metrics.
  [[nodiscard]] std::string why_not_ready() const;
  [[nodiscard]] std::string metrics_text() const;

 private:
  [[nodiscard]] Service service(const Options& options);
  // Of so many cores, those that no job is on now.
  [[nodiscard]] std::size_t idle_cores(std::size_t cores) const;

  const std::chrono::seconds drain_patience_;
  std::atomic<bool> draining_{};
  Metrics metrics_;
  const std::shared_ptr<TransportCounts> connections_ = std::make_shared<TransportCounts>();
  SumCache sums_;
  std::unique_ptr<Journal> journal_;  // null: markers live in memory only
  MarkerStore store_;
  Watchers watchers_;
  ThreadCrew crew_;
  Methods methods_;
  DeadlineClock clock_;
  JobQueue parsing_;
  JobQueue reads_;
  JobQueue motions_;
  JobQueue hands_;
  Drags drags_;
  Dispatcher dispatcher_;
  Transport transport_;
};

}  // namespace selvage
