// The methods that work on one marker: the one table that the daemon and the command line both run.
//
// A new method is a line in its family's file in methods/, with its decoder and its run beside it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "protocol/calls/method.h"
#include "protocol/execution/stage_times.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::methods {

[[nodiscard]] std::span<const calls::MarkerMethod> marker_methods();
// Null when there is none of this name.
[[nodiscard]] const calls::MarkerMethod* find_marker_method(std::string_view name);

// The whole result of a call: {"markerId", "revision", ...fields}.
[[nodiscard]] Json result_json(const std::string& marker_id, Revision revision, const Json& fields);
// Adds "ms" and "cache", which vary from run to run.
void tell_times(Json& fields, const execution::StageTimes& times, const minkowski::CacheCounts& cache);

// What an error of the method's run is on the wire: kMotionRefused when the marker does not allow the motion, or
// the run was stopped without an answer; else kInvalidParams.
[[nodiscard]] rpc::RpcCode code_of_run(const calls::MarkerMethod& method, const Error& error);

}  // namespace selvage::protocol::methods
