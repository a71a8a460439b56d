#include "protocol/calls/answer.h"

#include "protocol/calls/results.h"

namespace selvage::protocol::calls {

Json result_json(const std::string& marker_id, Revision revision, const Json& fields) {
  Json result = schema::encode(AtRevision{marker_id, revision});
  result.update(fields);
  return result;
}

void add_times(Json& fields, const execution::StageTimes& times, const minkowski::CacheCounts& cache) {
  fields["ms"] = schema::encode(stage_times_of(times));
  fields["cache"] = schema::encode(cache_counts_of(cache));
}

rpc::RpcCode code_of_run(const Method& method, const Error& error) {
  constexpr int kFirstOfShapes = 1100;  // codes below it are of invalid parameters
  const bool refused = method.motion && static_cast<int>(error.code) >= kFirstOfShapes;
  return refused || error.code == ErrorCode::kStoppedEarly ? rpc::RpcCode::kMotionRefused
                                                           : rpc::RpcCode::kInvalidParams;
}

rpc::RpcError unknown_method(const std::string& name) {
  return {rpc::RpcCode::kMethodNotFound, "there is no method '" + name + "'", {}};
}

rpc::RpcError not_open(const std::string& marker_id) {
  return {rpc::RpcCode::kUnknownMarker, "no marker '" + marker_id + "' is open", Json{{"field", "/markerId"}}};
}

rpc::RpcError revision_mismatch(const std::string& marker_id, Revision wanted, Revision present) {
  return {rpc::RpcCode::kRevisionMismatch,
          "marker '" + marker_id + "' is at revision " + std::to_string(present) + ", not " + std::to_string(wanted),
          Json{{"revision", present}}};
}

rpc::RpcError nothing_to_undo(bool undo) {
  return rpc::rpc_error(Error{ErrorCode::kNothingToUndo, undo ? "nothing to undo" : "nothing to redo", ""},
                        rpc::RpcCode::kMotionRefused);
}

rpc::RpcError abandoned() {
  return {rpc::RpcCode::kCancelled, "the call was cancelled, or its caller disconnected, before it ended", {}};
}

rpc::RpcError past_deadline(Error error) {
  error.message = "the deadline passed: " + error.message;
  return rpc::rpc_error(error, rpc::RpcCode::kMotionRefused);
}

}  // namespace selvage::protocol::calls
