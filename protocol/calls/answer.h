// Converts the outcome of a method's run to the result or the error of the call.
#pragma once

#include <string>

#include "core/minkowski/cache.h"
#include "protocol/calls/method.h"
#include "protocol/execution/stage_times.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::calls {

// The whole result of a call: {"markerId", "revision", ...fields}.
[[nodiscard]] Json result_json(const std::string& marker_id, Revision revision, const Json& fields);

// Adds "ms" and "cache", which vary from run to run.
void add_times(Json& fields, const execution::StageTimes& times, const minkowski::CacheCounts& cache);

// The code for an error of the method's run: kMotionRefused if the marker does not allow the motion or the run was
// stopped before it had a result; otherwise kInvalidParams.
[[nodiscard]] rpc::RpcCode code_of_run(const Method& method, const Error& error);

// The errors of programs that keep open markers: the daemon, and the engine embedded in a program.
[[nodiscard]] rpc::RpcError unknown_method(const std::string& name);
[[nodiscard]] rpc::RpcError not_open(const std::string& marker_id);
[[nodiscard]] rpc::RpcError revision_mismatch(const std::string& marker_id, Revision wanted, Revision present);
[[nodiscard]] rpc::RpcError nothing_to_undo(bool undo);  // false: there is nothing to redo
// For a call whose caller no longer waits for an answer.
[[nodiscard]] rpc::RpcError abandoned();
// For a call that was stopped by its deadline before it had a result.
[[nodiscard]] rpc::RpcError past_deadline(Error error);

}  // namespace selvage::protocol::calls
