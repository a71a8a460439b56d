// The subcommands of `selvage`.  Each adds itself to the command line; when it is the one chosen, it runs and
// leaves its exit code.
#pragma once

#include <CLI/CLI.hpp>

#include "clients/cli/terminal/exit_code.h"

namespace selvage::cli::commands {

void add_compact_command(CLI::App& app, terminal::ExitCode& code);
void add_bump_command(CLI::App& app, terminal::ExitCode& code);
void add_separate_command(CLI::App& app, terminal::ExitCode& code);
void add_float_command(CLI::App& app, terminal::ExitCode& code);
void add_tilt_command(CLI::App& app, terminal::ExitCode& code);
void add_call_command(CLI::App& app, terminal::ExitCode& code);
void add_check_command(CLI::App& app, terminal::ExitCode& code);
void add_show_command(CLI::App& app, terminal::ExitCode& code);
void add_convert_command(CLI::App& app, terminal::ExitCode& code);
void add_watch_command(CLI::App& app, terminal::ExitCode& code);

}  // namespace selvage::cli::commands
