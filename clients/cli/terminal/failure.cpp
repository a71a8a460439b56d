#include "clients/cli/terminal/failure.h"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "clients/cli/terminal/style.h"
#include "protocol/json/fields.h"

namespace selvage::cli::terminal {

std::string with_name(const std::string& message, std::string_view name) {
  if (name.empty()) return message;
  const std::string_view hint =
      name == wire_name(ErrorCode::kMarkerOverlaps)
          ? "\n`selvage separate` moves overlapping pieces apart; `--overlap` allows intended overlaps."
          : "";
  return message + " [" + std::string{name} + "]" + std::string{hint};
}

std::string message_of(const Error& error) {
  return with_name(protocol::json::describe(error), wire_name(error.code));
}

Failure failure_of(const Error& error) {
  return {message_of(error), error.code == ErrorCode::kFile ? ExitCode::kFile : ExitCode::kBadInput};
}

Failure bad_usage(std::string message) {
  return {std::move(message) + "\nRun with --help for more information.", ExitCode::kBadUsage};
}

ExitCode report(const Failure& failure) {
  std::cerr << Style{STDERR_FILENO}.bad("selvage:") << " " << failure.message << "\n";
  return failure.code;
}

ExitCode report(const Error& error) {
  return report(failure_of(error));
}

}  // namespace selvage::cli::terminal
