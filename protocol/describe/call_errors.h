// The errors that calls may return, for the daemon's description of itself. protocol/README.md explains their data.
#pragma once

#include <span>
#include <string_view>

#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::describe {

struct CallError {
  enum class When { kAny, kWithMarker, kWithBaseRevision, kMotion };

  rpc::RpcCode code{};
  std::string_view name, meaning;
  When when{};  // the methods that may return it
};

[[nodiscard]] std::span<const CallError> call_errors();

}  // namespace selvage::protocol::describe
