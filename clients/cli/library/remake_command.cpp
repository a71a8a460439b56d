#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands/marker_run.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/library/folder.h"
#include "clients/cli/library/library_commands.h"
#include "clients/cli/parameters/parameter_options.h"
#include "clients/cli/terminal/files.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::library {
namespace {

using command_line::Kind;
using parameters::ParameterOption;

// The library takes the place of the parameter with the stored markers.
std::vector<ParameterOption> remake_options() {
  auto options = parameters::parameter_options(*protocol::methods::find_method("marker.remake"));
  std::erase_if(options, [](const ParameterOption& option) { return option.parameter.name == "stored"; });
  return options;
}

// The nearest markers as documents.  Errors: those of reading the order or the library; kFile for an empty library.
Result<Json> stored_near(const std::string& order, const std::string& folder) {
  const auto file = terminal::load_marker(order);
  if (!file) return file.error();
  const auto library = list_folder(folder);
  if (!library) return library.error();
  if (library->empty()) return Error{ErrorCode::kFile, folder + ": there are no markers in the library", ""};
  auto near = nearest_in(*library, file->marker, kConsidered);
  if (!near) return near.error();
  if (near->empty()) {  // any of them: the answer says that none is near
    auto first = terminal::load_marker(library->front().path);
    if (!first) return first.error();
    near->push_back({library->front().name, *std::move(first)});
  }
  return documents_of(*near);
}

terminal::ExitCode run_remake(const std::vector<ParameterOption>& options, const command_line::Values& values) {
  const commands::MarkerFiles files = commands::marker_files(values, "ORDER");
  if (const auto failure = check_outputs(files)) return report(*failure);
  if (files.in.path == terminal::kStandardStream) {
    return report(terminal::bad_usage("the order is read twice, so it cannot be standard input"));
  }
  auto params = parameters::params_from(options, values);
  if (!params) return terminal::report(params.error());
  auto stored = stored_near(files.in.path, values.text("library"));
  if (!stored) return terminal::report(stored.error());
  (*params)["stored"] = *std::move(stored);
  if (const auto seconds = values.number("time")) (*params)["deadlineMs"] = 1000 * *seconds;
  return run_on_marker("marker.remake", *std::move(params), files,
                       values.flag("json") ? commands::Report::kJsonLine : commands::Report::kSummary);
}

}  // namespace

command_line::Command remake_command() {
  std::vector<ParameterOption> parameters = remake_options();
  command_line::Command command{"remake",
                                "Arranges the pieces of an order like those of the most similar markers of a library",
                                {{.name = "ORDER",
                                  .kind = Kind::kText,
                                  .meaning = "Marker or pattern file with the pieces; their positions do not matter",
                                  .required = true},
                                 {.name = "--library",
                                  .kind = Kind::kText,
                                  .meaning = "Folder of marker files, which `selvage library add` fills",
                                  .required = true,
                                  .placeholder = "FOLDER"}},
                                {}};
  for (const ParameterOption& parameter : parameters) command.options.push_back(parameter.option);
  for (command_line::Option& option : commands::file_options()) command.options.push_back(std::move(option));
  command.options.push_back(commands::time_option("result"));
  command.options.push_back(commands::json_option());
  command.examples = {"selvage library add markers made/*.json",
                      "selvage remake order.json --library markers -o marker.json --svg marker.svg",
                      "selvage remake order.json --library markers --tries 10 --fine --time 60 -o marker.json"};
  command.run = [parameters = std::move(parameters)](const command_line::Values& values) {
    return run_remake(parameters, values);
  };
  return command;
}

}  // namespace selvage::cli::library
