#include <iostream>
#include <memory>

#include "clients/cli/commands.h"
#include "clients/cli/files.h"
#include "clients/cli/remote.h"
#include "clients/cli/summary.h"

namespace selvage {
namespace {

struct ShowOptions {
  std::string in, svg;
  ServerChoice server;
};

ExitCode run(const ShowOptions& options) {
  const auto file = load_marker(options.in);
  if (!file) {
    report(file.error());
    return exit_code_of(file.error());
  }
  tell_notes(file->notes);
  const auto text = text_of(*file, Format::kSvg, options.server);
  if (const auto* refusal = std::get_if<Refusal>(&text)) return fail(*refusal);
  if (const auto error = write_text(options.svg, std::get<std::string>(text))) {
    report(*error);
    return exit_code_of(*error);
  }
  if (options.svg != kStandardStream) std::cout << plain_figures(file->marker) << "\n";
  return ExitCode::kOk;
}

}  // namespace

void add_show_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* command = app.add_subcommand("show", "Draw a marker as it is");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--svg", options->svg, "Write the drawing here; - for standard output")->required();
  command->footer(kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage
