// What each method does with the markers that are open in this process.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <variant>

#include "clients/engine/open_markers.h"
#include "core/base/executor.h"
#include "core/minkowski/cache.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::engine {

// Who made a call.
struct Caller {
  std::stop_token stop;  // asks to end the call; then it changes nothing
  // After each round of a motion: its number, and the marker's length after it in the marker's unit.
  std::function<void(int round, double length)> on_round = [](int, double) {};
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
