// The subcommands of `selvage`.  Each of them declares its options as data and has a function that runs it.
#pragma once

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::commands {

[[nodiscard]] command_line::Command check_command();
[[nodiscard]] command_line::Command show_command();
[[nodiscard]] command_line::Command convert_command();
[[nodiscard]] command_line::Command call_command();
[[nodiscard]] command_line::Command watch_command();

}  // namespace selvage::cli::commands
