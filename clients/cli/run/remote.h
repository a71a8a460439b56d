// Runs commands on a daemon: opens the marker there, calls a method, fetches the result and closes the marker again.
//
// A build without the C++ client (CMake option SELVAGE_REMOTE=OFF) compiles no_remote.cpp instead of remote.cpp,
// remote_marker.cpp and watch.cpp; every function below then fails with a message that says so.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <variant>

#include "clients/cli/run/invocation.h"
#include "clients/cli/run/server_choice.h"
#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/progress.h"

namespace selvage::cli::run {

[[nodiscard]] std::variant<Outcome, terminal::Failure> run_remotely(const ServerChoice& server,
                                                                    const Invocation& invocation,
                                                                    const std::stop_token& stop,
                                                                    terminal::ProgressLine& progress);

// Sends a call without a marker from a file, and returns its result.
[[nodiscard]] std::variant<Json, terminal::Failure> call_remotely(const ServerChoice& server, std::string_view method,
                                                                  const Json& params);

// The fields of marker.check's result.
[[nodiscard]] std::variant<Json, terminal::Failure> check_remotely(const ServerChoice& server, const MarkerFile& file);

// The text of a marker in the format of this name, written by the daemon.
[[nodiscard]] std::variant<std::string, terminal::Failure> text_remotely(const ServerChoice& server,
                                                                         const MarkerFile& file,
                                                                         std::string_view format);

// Prints one line for the current state of a marker that is open on the daemon and one for every change, until it is
// closed or SIGINT arrives.  `json`: print the daemon's messages instead of readable lines.
[[nodiscard]] terminal::ExitCode watch(const ServerChoice& server, const std::string& marker_id, bool json);

}  // namespace selvage::cli::run
