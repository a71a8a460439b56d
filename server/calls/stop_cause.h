// Why a call is asked to stop before its method has finished.
#pragma once

namespace selvage::server::calls {

enum class StopCause {
  kNone,          // it has not been asked to stop
  kCancelled,     // its caller sent $/cancelRequest
  kDeadline,      // its time is up: the best result so far is wanted
  kDraining,      // the server is shutting down: the best result so far is wanted
  kDisconnected,  // its caller has disconnected
};

// Nobody waits for the result any more.
[[nodiscard]] constexpr bool is_abandoned(StopCause cause) {
  return cause == StopCause::kCancelled || cause == StopCause::kDisconnected;
}

}  // namespace selvage::server::calls
