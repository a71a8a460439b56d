#include "protocol/describe/call_errors.h"

#include <array>

namespace selvage::protocol::describe {

std::span<const CallError> call_errors() {
  using rpc::RpcCode;
  using When = CallError::When;
  static constexpr std::array kErrors{
      CallError{RpcCode::kInvalidParams, "InvalidParams", "A parameter is invalid; data.field points at it.",
                When::kAny},
      CallError{RpcCode::kInternalError, "InternalError", "An internal error of the daemon.", When::kAny},
      CallError{RpcCode::kMotionRefused,
                "MotionRefused",
                "The marker does not allow this, or the deadline passed before there was a result.",
                When::kMotion,
                {"marker.undo", "marker.redo", "library.add"}},
      CallError{RpcCode::kBusy, "Busy",
                "The queue is full, or the call would not start before its deadline; data.retryAfterMs.", When::kAny},
      CallError{RpcCode::kUnknownMarker, "UnknownMarker", "There is no marker with this id.", When::kWithMarker},
      CallError{RpcCode::kLimit, "Limit", "A limit of this server was reached; data.limit.", When::kAny},
      CallError{RpcCode::kDraining, "Draining", "The server is shutting down and takes no new work.", When::kAny},
      CallError{RpcCode::kUnauthorised, "Unauthorised", "The connection has not sent the token.", When::kAny},
      CallError{RpcCode::kCancelled, "Cancelled", "The client cancelled the call.", When::kAny},
      CallError{RpcCode::kRevisionMismatch, "RevisionMismatch", "The marker is at another revision; data.revision.",
                When::kWithBaseRevision},
      CallError{RpcCode::kSuperseded,
                "Superseded",
                "A newer call of the same kind replaced this one before it began.",
                When::kNamed,
                {"drag.move"}},
  };
  return kErrors;
}

}  // namespace selvage::protocol::describe
