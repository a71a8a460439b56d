// The errors that several of the server's methods answer with.
#pragma once

#include <string>

#include "protocol/calls/messages.h"
#include "server/calls/outcome.h"

namespace selvage::server::calls {

inline protocol::rpc::RpcError unknown_marker(const std::string& id) {
  return {protocol::rpc::RpcCode::kUnknownMarker, "no marker '" + id + "' is open", Json{{"field", "/markerId"}}};
}
inline protocol::rpc::RpcError revision_mismatch(const std::string& id, Revision wanted, Revision present) {
  return {protocol::rpc::RpcCode::kRevisionMismatch,
          "marker '" + id + "' is at revision " + std::to_string(present) + ", not " + std::to_string(wanted),
          Json{{"revision", present}}};
}
inline protocol::rpc::RpcError limit_reached(const std::string& what, std::size_t limit) {
  return {protocol::rpc::RpcCode::kLimit, what + ": the limit is " + std::to_string(limit), Json{{"limit", limit}}};
}
inline protocol::rpc::RpcError nobody_waits() {
  return {protocol::rpc::RpcCode::kCancelled, "the caller left, or cancelled the call, before it ended", {}};
}
inline protocol::rpc::RpcError going_down() {
  return {protocol::rpc::RpcCode::kDraining, "the server is going down", {}};
}
inline protocol::rpc::RpcError not_written() {
  return {protocol::rpc::RpcCode::kInternalError, "the store could not be written; nothing was changed", {}};
}
inline protocol::rpc::RpcError no_notifications() {
  return {
      protocol::rpc::RpcCode::kInvalidRequest, "this connection cannot be notified: use /ws or a line connection", {}};
}

}  // namespace selvage::server::calls
