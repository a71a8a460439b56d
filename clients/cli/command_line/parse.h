// Parses the arguments of the process and selects the command to run.  The parsing library (CLI11) is visible in
// parse.cpp only, because its templates cost about ten seconds of compile time in every file that includes it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/cli/command_line/option.h"
#include "clients/cli/command_line/values.h"
#include "clients/cli/terminal/exit_code.h"

namespace selvage::cli::command_line {

// A subcommand.
struct Command {
  std::string name, summary;
  std::vector<Option> options;  // positional arguments in the order in which they are given
  std::function<terminal::ExitCode(const Values&)> run;
  std::vector<std::string> examples{};  // command lines, printed by --help
};

struct Program {
  std::string name, summary, version;
  std::string description;      // printed on the manual page, after the summary
  std::string footer;           // printed at the end of every --help
  std::vector<Option> options;  // may stand before or after the command's name
  std::vector<Command> commands;
};

struct Parsed {
  const Command* command{};                               // null if there is nothing to run
  Values values;                                          // of the options of the command and of the program
  terminal::ExitCode exit_code{terminal::ExitCode::kOk};  // when there is nothing to run
};

// Handles --help and --version, and reports errors of usage, for which the exit code is kBadUsage.  REQUIRES: the
// program outlives the result, and the keys of all options of a command and of the program differ.
[[nodiscard]] Parsed parse(const Program& program, int argc, const char* const* argv);

}  // namespace selvage::cli::command_line
