// Carries out calls on the markers that are open in this process.
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

// A round of a motion as a daemon reports it; lengths are in the marker's unit.
struct Round {
  int number{};
  double length{};                       // of the marker after the round
  std::optional<double> bound{};         // only from packing: a proved lower bound on the length
  std::optional<std::uint64_t> nodes{};  // only from exact searches: the number of nodes searched so far
};

// What the caller of a method supplies.
struct Caller {
  std::stop_token stop;  // cancels the call, which then changes nothing
  // Called after each round of a motion.
  std::function<void(const Round&)> on_round = [](const Round&) {};
};

// What all calls share.
struct Context {
  OpenMarkers& markers;
  SumCache& sums;
  const Executor& executor;
  std::size_t threads;
};

using Outcome = std::variant<Json, protocol::rpc::RpcError>;

// Carries out a request and returns its result or its error.
[[nodiscard]] Outcome serve(const protocol::rpc::Request& request, const Caller& caller, const Context& context);

}  // namespace selvage::engine
