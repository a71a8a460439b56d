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

}  // namespace selvage::protocol::calls
