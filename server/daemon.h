// The daemon: every part of it, put together, and the order in which they end.
#pragma once

#include <cstdint>
#include <memory>

#include "protocol/engine.h"
#include "server/deadline_clock.h"
#include "server/dispatcher.h"
#include "server/drags.h"
#include "server/job_queue.h"
#include "server/journal.h"
#include "server/marker_store.h"
#include "server/methods.h"
#include "server/options.h"
#include "server/transport/transport.h"
#include "server/watchers.h"

namespace selvage {

class Daemon {
 public:
  // Serves at once.  Throws when the address cannot be taken.
  explicit Daemon(const Options& options, Engine engine = {});
  ~Daemon();  // drains
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  [[nodiscard]] std::uint16_t port() const { return transport_.port(); }
  [[nodiscard]] const SumCache& sums() const { return sums_; }

  // Takes nothing new, asks what runs to hand back its best, sends every answer, closes.
  void drain();

 private:
  SumCache sums_;
  std::unique_ptr<Journal> journal_;  // null: markers live in memory only
  MarkerStore store_;
  Watchers watchers_;
  Methods methods_;
  DeadlineClock clock_;
  JobQueue reads_;
  JobQueue motions_;
  JobQueue hands_;
  Drags drags_;
  Dispatcher dispatcher_;
  Transport transport_;
};

}  // namespace selvage
