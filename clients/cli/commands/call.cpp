// selvage call: runs any of the daemon's methods, on a marker from a file or without one.
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/marker_run.h"
#include "clients/cli/run/local.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "protocol/json/fields.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::commands {
namespace {

using terminal::ExitCode;

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const protocol::calls::Method& method : protocol::methods::method_table().all()) {
    if (!method.name.starts_with('$')) names.emplace_back(method.name);
  }
  return names;
}

// Whether the method works on a marker from a file.
bool takes_marker(std::string_view name) {
  return name == run::kApply || protocol::methods::find_method(name)->on_marker;
}

// Whether the parameters are JSON text, which begins with a brace, rather than the name of a file.
bool is_written_out(const std::string& given) {
  const std::size_t first = given.find_first_not_of(" \t\n");
  return first != std::string::npos && given[first] == '{';
}

Result<Json> read_params(const std::string& given) {
  if (given.empty()) return Json::object();
  if (is_written_out(given)) {
    auto params = protocol::json::parse(given);
    if (params) return params;
    return Error{params.error().code, "PARAMS: " + protocol::json::describe(params.error()), ""};
  }
  const auto text = terminal::read_text(given);
  if (!text) return text.error();
  auto params = protocol::json::parse(*text);
  if (params) return params;
  return Error{params.error().code, given + ": " + protocol::json::describe(params.error()), ""};
}

// A call that concerns a marker that is open on a daemon, or the program itself.
ExitCode run_without_marker(const std::string& method, const Json& params, const run::ServerChoice& server) {
  auto answer = server ? run::call_remotely(server, method, params) : run::call_locally(method, params);
  if (const auto* failure = std::get_if<terminal::Failure>(&answer)) return report(*failure);
  std::cout << protocol::json::to_text(std::get<Json>(answer)) << std::endl;
  return ExitCode::kOk;
}

ExitCode run_call(const command_line::Values& values) {
  const std::string method = values.text("METHOD");
  const MarkerFiles files = marker_files(values, "marker");
  const std::string inline_params = values.text("PARAMS"), option = values.text("params");
  if (!inline_params.empty() && !option.empty())
    return report(terminal::bad_usage("give the parameters once: as PARAMS or with --params"));
  const std::string given = option.empty() ? inline_params : option;
  if (files.in.path == terminal::kStandardStream && given == terminal::kStandardStream)
    return report(terminal::bad_usage("only one of --marker and the parameters can be standard input"));
  if (!files.in.path.empty() && !takes_marker(method))
    return report(terminal::bad_usage(method + " does not work on a marker from a file; leave out --marker"));
  if (files.in.path.empty() && takes_marker(method) && !files.server)
    return report(terminal::bad_usage(method + " works on a marker: name its file with --marker"));
  const NamedFile params_file{option.empty() ? "PARAMS" : "--params", is_written_out(given) ? "" : given};
  if (const auto failure = check_outputs(files, {params_file})) return report(*failure);
  auto params = read_params(given);
  if (!params) return terminal::report(params.error());
  if (files.in.path.empty()) return run_without_marker(method, *params, files.server);
  return run_on_marker(method, *std::move(params), files, Report::kResult);
}

}  // namespace

command_line::Command call_command() {
  using command_line::Kind;
  command_line::Command command{
      "call",
      "Runs one of the daemon's methods",
      {{.name = "METHOD",
        .kind = Kind::kText,
        .meaning = "Name of the method; protocol/README.md describes them all",
        .required = true,
        .choices = method_names()},
       {.name = "PARAMS",
        .kind = Kind::kText,
        .meaning = "The method's parameters: JSON such as '{\"rounds\": 3}', a file, or - for standard input"},
       {.name = "--marker",
        .kind = Kind::kText,
        .meaning = "Marker or pattern file; - reads standard input.  With --server it may be omitted if the "
                   "parameters name a marker that is open there",
        .placeholder = "FILE"},
       {.name = "--params", .kind = Kind::kText, .meaning = "The same as PARAMS", .placeholder = "JSON"}},
      &run_call};
  for (command_line::Option& option : file_options()) command.options.push_back(std::move(option));
  command.examples = {"selvage call engine.info", "selvage call motion.compact '{\"rounds\": 3}' --marker marker.json",
                      "selvage call marker.list --server localhost:7171"};
  return command;
}

}  // namespace selvage::cli::commands
