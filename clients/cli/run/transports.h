// The two places where a method runs: in this process, from the daemon's own table of methods, and on a daemon.  The
// same comes of it either way.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>

#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/progress.h"
#include "protocol/methods/marker_methods.h"

namespace selvage::cli::run {

inline constexpr std::string_view kMarkerId = "m1";  // of the marker in this process
inline constexpr Revision kFirstRevision = 1;

struct Ran {
  std::string marker_id;
  Revision revision{};  // kFirstRevision: the marker was left as it was
  Json fields;          // of the result, but for markerId, revision, ms and cache
  protocol::execution::StageTimes times;
  minkowski::CacheCounts cache;
  MarkerFile end;
};

// A method, its parameters and the marker it is for, in words and as they were understood.
struct Task {
  const protocol::calls::MarkerMethod& method;
  const Json& params;
  const protocol::calls::MarkerCall& call;
  const MarkerFile& file;
};

[[nodiscard]] std::variant<Ran, Refusal> run_here(const Task& task, const Executor& executor,
                                                  const std::stop_token& stop, terminal::ProgressLine& progress);
// Opens the marker there, calls, fetches what came of it, and closes it again.
[[nodiscard]] std::variant<Ran, Refusal> run_there(const ServerChoice& server, const Task& task,
                                                   const std::stop_token& stop, terminal::ProgressLine& progress);

}  // namespace selvage::cli::run
