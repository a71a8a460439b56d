// Clients that try to make a daemon grow, each in one way.
#pragma once

#include <atomic>
#include <cstddef>
#include <string_view>
#include <vector>

#include "tests/trials/faults.h"
#include "tests/trials/live/live_daemon.h"

namespace selvage::trials {

// What greedy clients were answered.
struct Greed {
  std::atomic<std::size_t> results{}, refusals{}, hangups{};

  // A code that is neither a result's nor a refusal's is a fault.
  void count(int code, Faults& faults);
};

struct GreedyClient {
  std::string_view name;
  // Opens its own connections, and closes its markers in the end.
  void (*work)(const LiveDaemon&, Greed&, Faults&);
};

[[nodiscard]] const std::vector<GreedyClient>& greedy_clients();

}  // namespace selvage::trials
