#include <algorithm>
#include <iterator>
#include <memory>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"

namespace selvage::cli::commands {
namespace {

struct ConvertOptions {
  std::string in, out, format;
  run::ServerChoice server;
};

terminal::ExitCode run(const ConvertOptions& options) {
  const auto file = terminal::load_marker(options.in);
  if (!file) {
    terminal::report(file.error());
    return terminal::exit_code_of(file.error());
  }
  terminal::tell_notes(file->notes);
  const auto* const word = std::find(std::begin(protocol::document::kFormatNames),
                                     std::end(protocol::document::kFormatNames), options.format);
  const auto format = static_cast<Format>(word - std::begin(protocol::document::kFormatNames));
  const auto text = text_of(*file, format, options.server);
  if (const auto* refusal = std::get_if<run::Refusal>(&text)) return fail(*refusal);
  if (const auto error = terminal::write_text(options.out, std::get<std::string>(text))) {
    terminal::report(*error);
    return terminal::exit_code_of(*error);
  }
  return terminal::ExitCode::kOk;
}

}  // namespace

void add_convert_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Write a marker in another form, unmoved");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("-o,--out", options->out, "Write it here; - for standard output")->required();
  command->add_option("--format", options->format, "native, sparrow, outlines or svg")
      ->required()
      ->check(CLI::IsMember({"native", "sparrow", "outlines", "svg"}));
  command->footer(terminal::kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = run::server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage::cli::commands
