#include <iostream>
#include <memory>

#include "clients/cli/commands.h"
#include "clients/cli/files.h"
#include "clients/cli/remote.h"
#include "clients/cli/summary.h"
#include "protocol/codec.h"

namespace selvage {
namespace {

struct CheckOptions {
  std::string in;
  std::optional<double> spacing;
  bool json{};
  ServerChoice server;
};

// The fields of marker.check's answer.
std::variant<Json, Refusal> validity_of(const MarkerFile& file, const ServerChoice& server) {
  if (!server) {
    SumCache sums;
    return validity_json(file.marker, check(file.marker, sums));
  }
  RemoteMarker remote;
  if (auto refusal = remote.open(server, file)) return *std::move(refusal);
  auto answer = remote.call("marker.check", Json::object());
  if (auto* result = std::get_if<Json>(&answer)) {
    result->erase("markerId");
    result->erase("revision");
  }
  return answer;
}

ExitCode run(const CheckOptions& options) {
  auto file = load_marker(options.in);
  if (file && options.spacing) file = with_spacing(*std::move(file), *options.spacing);
  if (!file) {
    report(file.error());
    return exit_code_of(file.error());
  }
  const auto judged = validity_of(*file, options.server);
  if (const auto* refusal = std::get_if<Refusal>(&judged)) return fail(*refusal);
  const Json& validity = std::get<Json>(judged);
  const bool valid = validity["valid"] == true;
  if (options.json) {
    std::cout << to_text(validity) << "\n";
  } else {
    tell_notes(file->notes);
    std::cout << plain_figures(file->marker) << ": " << (valid ? "valid" : "NOT valid") << "\n"
              << plain_faults(file->marker, validity);
  }
  return valid ? ExitCode::kOk : ExitCode::kNotValid;
}

}  // namespace

void add_check_command(CLI::App& app, ExitCode& code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Is a marker valid?  Decided exactly; lists what is wrong");
  command->add_option("IN", options->in, "The marker, native or sparrow; - for standard input")->required();
  command->add_option("--spacing", options->spacing, "Least distance between pieces, in the marker's unit");
  command->add_flag("--json", options->json, "Print the answer as one line of JSON");
  command->footer(kExitCodesHelp);
  command->callback([options, command, &code] {
    options->server = server_choice(*command);
    code = run(*options);
  });
}

}  // namespace selvage
