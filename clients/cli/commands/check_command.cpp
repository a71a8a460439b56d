#include <iostream>
#include <memory>

#include "clients/cli/commands/commands.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/calls/codec.h"

namespace selvage::cli::commands {
namespace {

struct CheckOptions {
  std::string in;
  std::optional<double> spacing;
  bool json{};
  run::ServerChoice server;
};

// The fields of marker.check's answer.
std::variant<Json, run::Refusal> validity_of(const MarkerFile& file, const run::ServerChoice& server) {
  if (!server) {
    SumCache sums;
    return protocol::calls::validity_json(file.marker, check(file.marker, sums));
  }
  run::RemoteMarker remote;
  if (auto refusal = remote.open(server, file)) return *std::move(refusal);
  auto answer = remote.call("marker.check", Json::object());
  if (auto* result = std::get_if<Json>(&answer)) {
    result->erase("markerId");
    result->erase("revision");
  }
  return answer;
}

terminal::ExitCode run(const CheckOptions& options) {
  auto file = terminal::load_marker(options.in);
  if (file && options.spacing) file = protocol::formats::with_spacing(*std::move(file), *options.spacing);
  if (!file) {
    terminal::report(file.error());
    return terminal::exit_code_of(file.error());
  }
  const auto judged = validity_of(*file, options.server);
  if (const auto* refusal = std::get_if<run::Refusal>(&judged)) return fail(*refusal);
  const Json& validity = std::get<Json>(judged);
  const bool valid = validity["valid"] == true;
  if (options.json) {
    std::cout << protocol::json::to_text(validity) << "\n";
  } else {
    terminal::tell_notes(file->notes);
    std::cout << terminal::plain_figures(file->marker) << ": " << (valid ? "valid" : "NOT valid") << "\n"
              << terminal::plain_faults(file->marker, validity);
  }
  return valid ? terminal::ExitCode::kOk : terminal::ExitCode::kNotValid;
}

}  // namespace

void add_check_command(CLI::App& app, terminal::ExitCode& code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Is a marker valid?  Decided exactly; lists what is wrong");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--spacing", options->spacing, "Least distance between pieces, in the marker's unit");
  command->add_flag("--json", options->json, "Print the answer as one line of JSON");
  command->footer(terminal::kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = run::server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage::cli::commands
