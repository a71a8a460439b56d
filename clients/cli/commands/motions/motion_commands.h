// Makes a command for each motion in the table of methods: `selvage compact IN ...`.
#pragma once

#include <vector>

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::commands::motions {

[[nodiscard]] std::vector<command_line::Command> motion_commands();

}  // namespace selvage::cli::commands::motions
