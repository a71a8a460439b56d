// Why a command cannot continue: a message for stderr and the exit code.
#pragma once

#include <string>
#include <string_view>

#include "clients/cli/terminal/exit_code.h"
#include "core/base/error.h"

namespace selvage::cli::terminal {

struct Failure {
  std::string message;
  ExitCode code{};
};

// Makes a failure of an error that occurred while reading, writing or decoding.
[[nodiscard]] Failure failure_of(const Error& error);
// "MESSAGE [NAME]", followed by advice for some errors; the message alone if there is no name.
[[nodiscard]] std::string with_name(const std::string& message, std::string_view name);
// The same for an error of this process.
[[nodiscard]] std::string message_of(const Error& error);
// An incorrect command line, for errors that only the command itself can detect.
[[nodiscard]] Failure bad_usage(std::string message);

// Prints the message to stderr after the program's name, and returns the exit code.
[[nodiscard]] ExitCode report(const Failure& failure);
[[nodiscard]] ExitCode report(const Error& error);

}  // namespace selvage::cli::terminal
