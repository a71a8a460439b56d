// selvage: compacts, bumps, separates, floats, tilts, checks, shows and converts markers from the command line, here or
// on a daemon.
#include <iostream>
#include <string>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/server_option.h"

namespace {

// Says which word stands where a subcommand belongs.
void tell_subcommands(const CLI::App& app, const std::string& word) {
  std::cerr << "selvage: " << word << " is no subcommand; these are:";
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    std::cerr << ' ' << command->get_name();
  }
  std::cerr << "\nRun with --help for more information.\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Selvage shortens garment markers: exactly, fast, and never with an overlap."};
  app.name("selvage");
  app.set_version_flag("--version", std::string{"selvage "} + SELVAGE_VERSION);
  app.require_subcommand(1);
  app.footer(selvage::cli::terminal::kExitCodesHelp);
  selvage::cli::run::add_server_options(app);
  selvage::cli::terminal::ExitCode code = selvage::cli::terminal::ExitCode::kOk;
  selvage::cli::commands::add_compact_command(app, code);
  selvage::cli::commands::add_bump_command(app, code);
  selvage::cli::commands::add_separate_command(app, code);
  selvage::cli::commands::add_float_command(app, code);
  selvage::cli::commands::add_tilt_command(app, code);
  selvage::cli::commands::add_check_command(app, code);
  selvage::cli::commands::add_show_command(app, code);
  selvage::cli::commands::add_convert_command(app, code);
  selvage::cli::commands::add_call_command(app, code);
  selvage::cli::commands::add_watch_command(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const auto words = app.remaining();
    const bool none_found = app.get_subcommands().empty() && !words.empty() && words.front().front() != '-';
    if (error.get_name() == "RequiredError" && none_found) {
      tell_subcommands(app, words.front());
      return static_cast<int>(selvage::cli::terminal::ExitCode::kBadUsage);
    }
    const bool asked_for_help = app.exit(error) == 0;
    code = asked_for_help ? selvage::cli::terminal::ExitCode::kOk : selvage::cli::terminal::ExitCode::kBadUsage;
  }
  return static_cast<int>(code);
}
