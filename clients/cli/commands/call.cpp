// selvage call: runs any of the daemon's methods that work on one marker.
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/marker_run.h"
#include "clients/cli/run/local.h"
#include "clients/cli/terminal/files.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::commands {
namespace {

std::vector<std::string> method_names() {
  std::vector<std::string> names{std::string{run::kApply}};
  for (const protocol::calls::Method& method : protocol::methods::method_table().all()) {
    if (method.on_marker) names.emplace_back(method.name);
  }
  return names;
}

Result<Json> read_params(const std::string& path) {
  if (path.empty()) return Json::object();
  const auto text = terminal::read_text(path);
  if (!text) return text.error();
  return protocol::json::parse(*text);
}

terminal::ExitCode run_call(const command_line::Values& values) {
  const MarkerFiles files = marker_files(values, "marker");
  const std::string params_path = values.text("params");
  if (files.in == terminal::kStandardStream && params_path == terminal::kStandardStream)
    return report(terminal::bad_usage("only one of --marker, --params can be standard input"));
  if (const auto failure = check_outputs(files)) return report(*failure);
  auto params = read_params(params_path);
  if (!params) return terminal::report(params.error());
  return run_on_marker(values.text("METHOD"), *std::move(params), files, Report::kResult);
}

}  // namespace

command_line::Command call_command() {
  using command_line::Kind;
  command_line::Command command{"call",
                                "Run one of the daemon's methods on a marker",
                                {{.name = "METHOD",
                                  .kind = Kind::kText,
                                  .meaning = "Name of the method; protocol/README.md describes them all",
                                  .required = true,
                                  .choices = method_names()},
                                 {.name = "--marker",
                                  .kind = Kind::kText,
                                  .meaning = "Marker in native or sparrow format; - reads standard input",
                                  .required = true},
                                 {.name = "--params",
                                  .kind = Kind::kText,
                                  .meaning = "JSON file of the method's parameters; - reads standard input"}},
                                &run_call};
  for (command_line::Option& option : file_options()) command.options.push_back(std::move(option));
  return command;
}

}  // namespace selvage::cli::commands
