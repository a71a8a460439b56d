// selvage: works on markers from the command line, in this process or on a daemon.
#include <vector>

#include "clients/cli/command_line/parse.h"
#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/motions/motion_commands.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/documents/completion.h"
#include "clients/cli/documents/manual.h"
#include "clients/cli/library/library_commands.h"
#include "clients/cli/planning/plan_command.h"

namespace {

constexpr const char* kDescription =
    "A marker is a layout of garment pieces on a strip of cloth.  Most subcommands read a marker, carry out one "
    "operation, print a summary, and write the result to the file given with -o: nest, pack and remake make a "
    "layout; compact, tilt and fill make it shorter; bump, place, separate and float move pieces; check, "
    "show and convert do not change it.  The input may also be a pattern or cut file, and the output a plot, "
    "a cut file or a PDF.  With --server, a daemon does the work.";

// In the order of --help.
std::vector<selvage::cli::command_line::Command> all_commands() {
  namespace commands = selvage::cli::commands;
  std::vector<selvage::cli::command_line::Command> all = commands::motions::motion_commands();
  for (auto command : {&commands::check_command, &commands::show_command, &commands::convert_command,
                       &commands::call_command, &commands::watch_command}) {
    all.push_back(command());
  }
  all.push_back(selvage::cli::library::library_command());
  all.push_back(selvage::cli::library::remake_command());
  all.push_back(selvage::cli::planning::plan_command());
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = selvage::cli;
  cli::command_line::Program program{
      .name = "selvage",
      .summary = "Nests and compacts garment markers, and proves in exact arithmetic that no pieces overlap.",
      .version = SELVAGE_VERSION,
      .description = kDescription,
      .footer = cli::terminal::kExitCodesHelp,
      .options = cli::commands::server_options(),
      .commands = all_commands()};
  program.commands.push_back(cli::documents::completion_command(program));
  program.commands.push_back(cli::documents::manual_command(program));
  const cli::command_line::Parsed parsed = cli::command_line::parse(program, argc, argv);
  if (parsed.command == nullptr) return static_cast<int>(parsed.exit_code);
  return static_cast<int>(parsed.command->run(parsed.values));
}
