// What each method does with the markers that are open in this process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <variant>

#include "clients/engine/open_markers.h"
#include "core/base/executor.h"
#include "core/minkowski/cache.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::engine {

// A round of a motion as a daemon tells it; lengths are in the marker's unit.
struct Round {
  int number{};
  double length{};                       // of the marker after it
  std::optional<double> bound{};         // of packing: no marker is shorter
  std::optional<std::uint64_t> nodes{};  // of exact searches: searched so far
};

// Who made a call.
struct Caller {
  std::stop_token stop;  // asks to end the call; then it changes nothing
  // After each round of a motion.
  std::function<void(const Round&)> on_round = [](const Round&) {};
};

// What calls work with.
struct Means {
  OpenMarkers& markers;
  SumCache& sums;
  const Executor& executor;
  std::size_t threads;
};

using Outcome = std::variant<Json, protocol::rpc::RpcError>;

[[nodiscard]] Outcome serve(const protocol::rpc::Request& request, const Caller& caller, const Means& means);

}  // namespace selvage::engine
