// The errors that several of the server's methods answer with.
#pragma once

#include <string>

#include "protocol/messages.h"
#include "server/outcome.h"

namespace selvage {

inline RpcError unknown_marker(const std::string& id) {
  return {RpcCode::kUnknownMarker, "no marker '" + id + "' is open", Json{{"field", "/markerId"}}};
}
inline RpcError revision_mismatch(const std::string& id, Revision wanted, Revision present) {
  return {RpcCode::kRevisionMismatch,
          "marker '" + id + "' is at revision " + std::to_string(present) + ", not " + std::to_string(wanted),
          Json{{"revision", present}}};
}
inline RpcError limit_reached(const std::string& what, std::size_t limit) {
  return {RpcCode::kLimit, what + ": the limit is " + std::to_string(limit), Json{{"limit", limit}}};
}
inline RpcError nobody_waits() {
  return {RpcCode::kCancelled, "the caller left, or cancelled the call, before it ended", {}};
}
inline RpcError going_down() {
  return {RpcCode::kDraining, "the server is going down", {}};
}
inline RpcError not_written() {
  return {RpcCode::kInternalError, "the store could not be written; nothing was changed", {}};
}
inline RpcError no_notifications() {
  return {RpcCode::kInvalidRequest, "this connection cannot be notified: use /ws or a line connection", {}};
}

}  // namespace selvage
