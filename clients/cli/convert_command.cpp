#include <algorithm>
#include <iterator>
#include <memory>

#include "clients/cli/commands.h"
#include "clients/cli/files.h"
#include "clients/cli/remote.h"

namespace selvage {
namespace {

struct ConvertOptions {
  std::string in, out, format;
  ServerChoice server;
};

ExitCode run(const ConvertOptions& options) {
  const auto file = load_marker(options.in);
  if (!file) {
    report(file.error());
    return exit_code_of(file.error());
  }
  tell_notes(file->notes);
  const auto* const word = std::find(std::begin(kFormatNames), std::end(kFormatNames), options.format);
  const auto format = static_cast<Format>(word - std::begin(kFormatNames));
  const auto text = text_of(*file, format, options.server);
  if (const auto* refusal = std::get_if<Refusal>(&text)) return fail(*refusal);
  if (const auto error = write_text(options.out, std::get<std::string>(text))) {
    report(*error);
    return exit_code_of(*error);
  }
  return ExitCode::kOk;
}

}  // namespace

void add_convert_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Write a marker in another form, unmoved");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("-o,--out", options->out, "Write it here; - for standard output")->required();
  command->add_option("--format", options->format, "native, sparrow, outlines or svg")
      ->required()
      ->check(CLI::IsMember({"native", "sparrow", "outlines", "svg"}));
  command->footer(kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage
