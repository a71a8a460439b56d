// The errors that several of the server's methods return.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "protocol/calls/answer.h"
#include "server/calls/outcome.h"
#include "server/jobs/job_queue.h"
#include "server/store/marker_store.h"

namespace selvage::server::calls {

using protocol::calls::abandoned;
using protocol::calls::revision_mismatch;

// The error for a call that would need more memory for markers than is left.
inline protocol::rpc::RpcError no_room(const store::MarkerStore& store) {
  const std::size_t limit = store.room().account->limit();
  return {protocol::rpc::RpcCode::kLimit,
          "no memory is left for markers, their histories and the answers kept for retries: the limit is " +
              std::to_string(limit) + " bytes; close markers, or try again later",
          Json{{"limit", limit}}};
}
inline protocol::rpc::RpcError marker_too_large(const store::MarkerStore& store) {
  const std::size_t limit = store.room().marker_bytes;
  return {protocol::rpc::RpcCode::kLimit,
          "the marker would take more than " + std::to_string(limit) + " bytes of memory", Json{{"limit", limit}}};
}
// The error for a call about a marker that cannot be used.
inline protocol::rpc::RpcError unknown_marker(const store::MarkerStore& store, const std::string& id) {
  if (store.is_open(id)) return no_room(store);  // it could not be read from the journal
  const std::string damage = store.quarantine(id);
  if (damage.empty()) return protocol::calls::not_open(id);
  return {protocol::rpc::RpcCode::kUnknownMarker,
          "marker '" + id + "' is damaged in the store and can only be closed: " + damage,
          Json{{"field", "/markerId"}}};
}
inline protocol::rpc::RpcError limit_reached(const std::string& what, std::size_t limit) {
  return {protocol::rpc::RpcCode::kLimit, what + ": the limit is " + std::to_string(limit), Json{{"limit", limit}}};
}
inline protocol::rpc::RpcError shutting_down() {
  return {protocol::rpc::RpcCode::kDraining, "the server is shutting down", {}};
}
inline protocol::rpc::RpcError not_written() {
  return {protocol::rpc::RpcCode::kInternalError, "the store could not be written; nothing was changed", {}};
}
inline protocol::rpc::RpcError busy(const jobs::JobQueue& queue, const std::string& reason) {
  return {protocol::rpc::RpcCode::kBusy, reason, Json{{"retryAfterMs", queue.retry_after_ms()}}};
}
// The error for a call that had not started by its deadline.
inline protocol::rpc::RpcError not_begun(const jobs::JobQueue& queue) {
  return busy(queue, "the call's turn had not come at its deadline; nothing was done");
}
inline protocol::rpc::RpcError no_notifications() {
  return {protocol::rpc::RpcCode::kInvalidRequest,
          "this connection cannot receive notifications: use /ws or a line connection",
          {}};
}
inline protocol::rpc::RpcError no_connection_to_close_with() {
  return {protocol::rpc::RpcCode::kInvalidRequest,
          "closeWithConnection has no meaning over plain HTTP, where no connection lasts: use /ws or a line connection",
          Json{{"field", "/closeWithConnection"}}};
}
// REQUIRES: the queue did not accept the job.
inline protocol::rpc::RpcError not_admitted(jobs::Admission admission, const jobs::JobQueue& queue,
                                            const std::string& reason) {
  if (admission == jobs::Admission::kDraining) return shutting_down();
  if (admission == jobs::Admission::kTooLate) {
    return busy(queue, "calls now wait longer than this one can: its turn would not come before its deadline");
  }
  return busy(queue, reason);
}

}  // namespace selvage::server::calls
