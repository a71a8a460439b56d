// Runs a method in this process, from the table of methods that the daemon uses too.
#pragma once

#include <stop_token>
#include <variant>

#include "clients/cli/run/invocation.h"
#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/progress.h"
#include "core/base/executor.h"

namespace selvage::cli::run {

[[nodiscard]] std::variant<Outcome, terminal::Failure> run_locally(const Invocation& invocation,
                                                                   const Executor& executor,
                                                                   const std::stop_token& stop,
                                                                   terminal::ProgressLine& progress);

}  // namespace selvage::cli::run
