// The errors that calls may return, for the daemon's description of itself. protocol/README.md explains their data.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::describe {

struct CallError {
  // The methods that may return it: all; those with the parameter markerId or baseRev; motions and those with the
  // parameter deadlineMs; or only those that are named.
  enum class When { kAny, kWithMarker, kWithBaseRevision, kMotion, kNamed };

  rpc::RpcCode code{};
  std::string_view name, meaning;
  When when{};
  std::array<std::string_view, 3> also{};  // names of further methods that may return it
};

[[nodiscard]] std::span<const CallError> call_errors();

}  // namespace selvage::protocol::describe
