#include "clients/cli/terminal/failure.h"

#include <iostream>
#include <utility>

#include "protocol/json/fields.h"

namespace selvage::cli::terminal {

std::string message_of(const Error& error) {
  return protocol::json::describe(error) + " [" + std::string{wire_name(error.code)} + "]";
}

Failure failure_of(const Error& error) {
  return {message_of(error), error.code == ErrorCode::kFile ? ExitCode::kFile : ExitCode::kBadInput};
}

Failure bad_usage(std::string message) {
  return {std::move(message) + "\nRun with --help for more information.", ExitCode::kBadUsage};
}

ExitCode report(const Failure& failure) {
  std::cerr << "selvage: " << failure.message << "\n";
  return failure.code;
}

ExitCode report(const Error& error) {
  return report(failure_of(error));
}

}  // namespace selvage::cli::terminal
