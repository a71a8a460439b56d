#include <memory>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/by_hand.h"
#include "clients/cli/run/marker_run.h"
#include "clients/cli/terminal/files.h"
#include "protocol/methods/marker_methods.h"

namespace selvage::cli::commands {
namespace {

struct CallOptions {
  std::string method, params;
  run::MarkerFiles files;
};

terminal::ExitCode run(const CallOptions& options) {
  Json params = Json::object();
  if (!options.params.empty()) {
    const auto text = terminal::read_text(options.params);
    auto read = text ? protocol::json::parse(*text) : Result<Json>{text.error()};
    if (!read) {
      terminal::report(read.error());
      return terminal::exit_code_of(read.error());
    }
    params = *std::move(read);
  }
  return run_on_marker(options.method, std::move(params), options.files, run::Telling::kResult);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names{std::string{run::apply_method().name}};
  for (const protocol::calls::MarkerMethod& method : protocol::methods::marker_methods())
    names.emplace_back(method.name);
  return names;
}

}  // namespace

void add_call_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<CallOptions>();
  CLI::App* command = app.add_subcommand("call", "Run a method of the daemon on a marker");
  command->add_option("METHOD", options->method, "As in protocol/README.md")
      ->required()
      ->check(CLI::IsMember(method_names()));
  command->add_option("--marker", options->files.in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--params", options->params, "The method's parameters, a file of JSON; - for standard input");
  add_marker_files(*command, options->files);
  command->footer(terminal::kExitCodesHelp);
  command->callback([options, command, &code] {
    options->files.server = run::server_choice(*command);
    if (options->files.in == terminal::kStandardStream && options->params == terminal::kStandardStream)
      throw CLI::ValidationError("only one of --marker, --params can be standard input");
    refuse_mixed_streams(options->files);
    code = run(*options);
  });
}

}  // namespace selvage::cli::commands
