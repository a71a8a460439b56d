#include <iostream>
#include <memory>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/summary.h"

namespace selvage::cli::commands {
namespace {

struct ShowOptions {
  std::string in, svg;
  run::ServerChoice server;
};

terminal::ExitCode run(const ShowOptions& options) {
  const auto file = terminal::load_marker(options.in);
  if (!file) {
    terminal::report(file.error());
    return terminal::exit_code_of(file.error());
  }
  terminal::tell_notes(file->notes);
  const auto text = text_of(*file, Format::kSvg, options.server);
  if (const auto* refusal = std::get_if<run::Refusal>(&text)) return fail(*refusal);
  if (const auto error = terminal::write_text(options.svg, std::get<std::string>(text))) {
    terminal::report(*error);
    return terminal::exit_code_of(*error);
  }
  if (options.svg != terminal::kStandardStream) std::cout << terminal::plain_figures(file->marker) << "\n";
  return terminal::ExitCode::kOk;
}

}  // namespace

void add_show_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* command = app.add_subcommand("show", "Draw a marker as it is");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--svg", options->svg, "Write the drawing here; - for standard output")->required();
  command->footer(terminal::kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = run::server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage::cli::commands
