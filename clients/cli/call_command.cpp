#include <memory>
#include <vector>

#include "clients/cli/by_hand.h"
#include "clients/cli/commands.h"
#include "clients/cli/files.h"
#include "clients/cli/marker_run.h"
#include "protocol/marker_methods.h"

namespace selvage {
namespace {

struct CallOptions {
  std::string method, params;
  MarkerFiles files;
};

ExitCode run(const CallOptions& options) {
  Json params = Json::object();
  if (!options.params.empty()) {
    const auto text = read_text(options.params);
    auto read = text ? parse(*text) : Result<Json>{text.error()};
    if (!read) {
      report(read.error());
      return exit_code_of(read.error());
    }
    params = *std::move(read);
  }
  return run_on_marker(options.method, std::move(params), options.files, Telling::kResult);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names{std::string{apply_method().name}};
  for (const MarkerMethod& method : marker_methods()) names.emplace_back(method.name);
  return names;
}

}  // namespace

void add_call_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<CallOptions>();
  CLI::App* command = app.add_subcommand("call", "Run a method of the daemon on a marker");
  command->add_option("METHOD", options->method, "As in protocol/README.md")
      ->required()
      ->check(CLI::IsMember(method_names()));
  command->add_option("--marker", options->files.in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--params", options->params, "The method's parameters, a file of JSON; - for standard input");
  add_marker_files(*command, options->files);
  command->footer(kExitCodesHelp);
  command->callback([options, command, &code] {
    options->files.server = server_choice(*command);
    if (options->files.in == kStandardStream && options->params == kStandardStream)
      throw CLI::ValidationError("only one of --marker, --params can be standard input");
    refuse_mixed_streams(options->files);
    code = run(*options);
  });
}

}  // namespace selvage
