#include "clients/cli/exit_code.h"

#include <iostream>

#include "protocol/fields.h"

namespace selvage {

ExitCode exit_code_of(const Error& error) {
  return error.code == ErrorCode::kFile ? ExitCode::kFile : ExitCode::kBadInput;
}

void report(const Error& error) {
  std::cerr << "selvage: " << describe(error) << " [" << wire_name(error.code) << "]\n";
}

}  // namespace selvage
