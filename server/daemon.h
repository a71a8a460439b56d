// The daemon: every part of it, put together, and the order in which they end.
#pragma once

#include <cstdint>

#include "protocol/engine.h"
#include "server/dispatcher.h"
#include "server/job_queue.h"
#include "server/marker_store.h"
#include "server/methods.h"
#include "server/options.h"
#include "server/transport/transport.h"

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
  MarkerStore store_;
  Methods methods_;
  JobQueue reads_;
  JobQueue motions_;
  Dispatcher dispatcher_;
  Transport transport_;
};

}  // namespace selvage
