// One call of a method on one marker, and its outcome.  It runs in this process (local.h) or on a daemon (remote.h);
// the outcome is the same, apart from times, cache counts and the marker's id.
#pragma once

#include <string>
#include <string_view>

#include "core/minkowski/cache.h"
#include "protocol/calls/method.h"
#include "protocol/execution/stage_times.h"

namespace selvage::cli::run {

inline constexpr std::string_view kMarkerId = "m1";  // the id of the marker in this process
inline constexpr Revision kFirstRevision = 1;

// REQUIRES: the objects that it refers to outlive it, and `call` was decoded from `params`.
struct Invocation {
  const protocol::calls::Method& method;
  const Json& params;
  const protocol::calls::ParsedCall& call;
  const MarkerFile& file;
};

struct Outcome {
  std::string marker_id;
  Revision revision{};  // kFirstRevision: the marker did not change
  Json fields;          // of the result, without markerId, revision, ms and cache
  protocol::execution::StageTimes times;
  minkowski::CacheCounts cache;
  MarkerFile end;  // the marker after the call
};

}  // namespace selvage::cli::run
