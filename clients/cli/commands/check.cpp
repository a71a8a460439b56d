// selvage check: decides in exact arithmetic whether a marker is valid, and lists its defects.
#include <unistd.h>

#include <iostream>
#include <utility>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/run/local.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::cli::commands {
namespace {

// The fields of marker.check's result.
std::variant<Json, terminal::Failure> validity_of(const MarkerFile& file, const run::ServerChoice& server) {
  if (server) return run::check_remotely(server, file);
  return run::check_locally(file);
}

terminal::ExitCode run_check(const command_line::Values& values) {
  const auto file = overridden(terminal::load_marker(values.text("IN")), marker_overrides(values));
  if (!file) return terminal::report(file.error());
  const auto checked = validity_of(*file, server_choice(values));
  if (const auto* failure = std::get_if<terminal::Failure>(&checked)) return terminal::report(*failure);
  const Json& validity = std::get<Json>(checked);
  const bool valid = validity["valid"] == true;
  if (values.flag("json")) {
    std::cout << protocol::json::to_text(validity) << "\n";
  } else {
    terminal::print_notes(file->notes);
    const terminal::Style style{STDOUT_FILENO};
    std::cout << terminal::plain_figures(file->marker) << ": " << (valid ? style.good("valid") : style.bad("NOT valid"))
              << "\n"
              << terminal::plain_violations(file->marker, validity);
  }
  return valid ? terminal::ExitCode::kOk : terminal::ExitCode::kNotValid;
}

}  // namespace

command_line::Command check_command() {
  std::vector<command_line::Option> options{
      input_option(),
      {.name = "--json", .kind = command_line::Kind::kFlag, .meaning = "Print the result as one line of JSON"}};
  for (command_line::Option& option : override_options()) options.push_back(std::move(option));
  return {
      "check",
      "Decides in exact arithmetic whether a marker is valid: no overlaps, nothing outside the strip, no rule broken",
      std::move(options),
      &run_check,
      {"selvage check marker.json", "selvage check marker.json --spacing 2"}};
}

}  // namespace selvage::cli::commands
