// Clients that each try, in one way, to make a daemon's memory grow.
#pragma once

#include <atomic>
#include <cstddef>
#include <string_view>
#include <vector>

#include "tests/trials/faults.h"
#include "tests/trials/live/live_daemon.h"

namespace selvage::trials {

// The answers to greedy clients.
struct Greed {
  std::atomic<std::size_t> results{}, refusals{}, hangups{};

  // A code that belongs neither to a result nor to a refusal is a fault.
  void count(int code, Faults& faults);
};

struct GreedyClient {
  std::string_view name;
  // Opens its own connections, and closes its markers in the end.
  void (*work)(const LiveDaemon&, Greed&, Faults&);
};

[[nodiscard]] const std::vector<GreedyClient>& greedy_clients();

}  // namespace selvage::trials
