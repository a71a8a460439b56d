// The methods that work on one marker: the one table that the daemon and the command line both run.
//
// A method's parameters are read first, without the marker; what was read then runs on a marker and answers
// with fields and, when it changed the marker, with its next state.  Which markers there are, their
// revisions, threads and clocks are the caller's.  A new method is a line in the table of marker_methods.cpp,
// a function beside it and a decoder in codec.h.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

#include "protocol/engine.h"
#include "protocol/json_rpc.h"
#include "protocol/messages.h"

namespace selvage {

// What a method works with beside the marker.  REQUIRES: all outlive the run.
struct Means {
  const Engine& engine;
  SumCache& sums;
  std::stop_token stop;
  const Observer& observer;
};

struct MethodAnswer {
  Json fields;                 // all but markerId and revision
  std::optional<Marker> next;  // the marker's next state; none: it stays as it is
};

// A call whose parameters were understood.
struct MarkerCall {
  MotionCall about;  // for methods that are no motions only its marker
  // Errors: 10xx for a parameter that does not suit this marker, `field` pointing into the parameters; others
  // when the marker does not allow the motion.
  std::function<Result<MethodAnswer>(const MarkerFile&, const Means&)> run;
};

struct MarkerMethod {
  std::string_view name;
  bool motion{};  // may change the marker, and may take long
  // Errors: 10xx, `field` pointing into the parameters.
  Result<MarkerCall> (*read)(const Json& params);
};
[[nodiscard]] std::span<const MarkerMethod> marker_methods();
// Null when there is none of this name.
[[nodiscard]] const MarkerMethod* find_marker_method(std::string_view name);

// The whole result of a call: {"markerId", "revision", ...fields}.
[[nodiscard]] Json result_json(const std::string& marker_id, Revision revision, const Json& fields);
// Adds "ms" and "cache", which vary from run to run.
void tell_times(Json& fields, const StageTimes& times, const CacheCounts& cache);

// What an error of the method's run is on the wire: kMotionRefused when the marker does not allow the motion,
// else kInvalidParams.
[[nodiscard]] RpcCode code_of_run(const MarkerMethod& method, const Error& error);

}  // namespace selvage
