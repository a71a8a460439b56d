// The subcommands of `selvage`: each declares its options as data and says how it runs.
#pragma once

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::commands {

[[nodiscard]] command_line::Command check_command();
[[nodiscard]] command_line::Command show_command();
[[nodiscard]] command_line::Command convert_command();
[[nodiscard]] command_line::Command call_command();
[[nodiscard]] command_line::Command watch_command();

}  // namespace selvage::cli::commands
