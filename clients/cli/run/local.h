// Runs methods in this process, from the same table of methods as the daemon's.
#pragma once

#include <string_view>
#include <variant>

#include "clients/cli/run/invocation.h"
#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/progress.h"
#include "core/base/executor.h"
#include "protocol/execution/time_limit.h"

namespace selvage::cli::run {

// The one method that runs here although the daemon serves it itself: besides the marker, it may change other parts of
// the file, such as the attributes of the pieces that it adds.
inline constexpr std::string_view kApply = "marker.apply";

// REQUIRES: the method works on one marker, or it is kApply.
[[nodiscard]] std::variant<Outcome, terminal::Failure> run_locally(const Invocation& invocation,
                                                                   const Executor& executor,
                                                                   const protocol::execution::TimeLimit& limit,
                                                                   terminal::ProgressLine& progress);

// Returns the result of a method that needs no marker from a file, such as engine.info.  Errors: those of the method; a
// method that only a daemon supports is refused.
[[nodiscard]] std::variant<Json, terminal::Failure> call_locally(std::string_view method, const Json& params);

// The fields of marker.check's result.
[[nodiscard]] std::variant<Json, terminal::Failure> check_locally(const MarkerFile& file);

}  // namespace selvage::cli::run
