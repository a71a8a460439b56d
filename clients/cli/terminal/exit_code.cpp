#include "clients/cli/terminal/exit_code.h"

#include <iostream>

#include "protocol/json/fields.h"

namespace selvage::cli::terminal {

ExitCode exit_code_of(const Error& error) {
  return error.code == ErrorCode::kFile ? ExitCode::kFile : ExitCode::kBadInput;
}

void report(const Error& error) {
  std::cerr << "selvage: " << protocol::json::describe(error) << " [" << wire_name(error.code) << "]\n";
}

}  // namespace selvage::cli::terminal
