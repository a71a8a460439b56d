// The manual page of the command, in roff with the man macros: `selvage manual | man -l -`.
#pragma once

#include <string>

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::documents {

[[nodiscard]] std::string manual_page(const command_line::Program& program);

// `selvage manual`.  REQUIRES: the program outlives the command.
[[nodiscard]] command_line::Command manual_command(const command_line::Program& program);

}  // namespace selvage::cli::documents
