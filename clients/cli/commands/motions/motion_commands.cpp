#include "clients/cli/commands/motions/motion_commands.h"

// `selvage compact IN --rounds 5` is `selvage call motion.compact` with its parameters given
// as options.  A motion that is added to the table of methods is a command without further code.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands/marker_run.h"
#include "clients/cli/commands/motions/examples.h"
#include "clients/cli/commands/motions/nest_on_sheets.h"
#include "clients/cli/parameters/parameter_options.h"
#include "protocol/methods/method_table.h"

namespace selvage::cli::commands::motions {
namespace {

using command_line::Option;
using parameters::option_name;
using parameters::ParameterOption;
using parameters::without_full_stop;
using protocol::calls::Method;

// "motion.openGap" becomes "open-gap"; marker.fillGaps has a shorter name.
std::string command_name(std::string_view method) {
  if (method == "marker.fillGaps") return "fill";
  method.remove_prefix(method.find('.') + 1);
  return option_name(method).substr(2);
}

// Its stored markers come from a library (clients/cli/library/remake_command.cpp).
constexpr std::string_view kRemake = "marker.remake";

// Whether the method has a time limit of its own, such as the seconds of a search, which replaces the deadline.
bool limits_time_itself(const std::vector<ParameterOption>& options) {
  return std::ranges::any_of(options,
                             [](const ParameterOption& parameter) { return parameter.option.name == "--time"; });
}

terminal::ExitCode run_motion(std::string_view method, const std::vector<ParameterOption>& options,
                              const command_line::Values& values) {
  const MarkerFiles files = marker_files(values, "IN");
  if (const auto failure = check_outputs(files)) return report(*failure);
  auto params = parameters::params_from(options, values);
  if (!params) return terminal::report(params.error());
  if (values.find("sheets") != nullptr) return nest_on_sheets(*std::move(params), files, values);
  if (const auto seconds = values.number("time"); seconds && !limits_time_itself(options)) {
    (*params)["deadlineMs"] = 1000 * *seconds;
  }
  return run_on_marker(method, *std::move(params), files, values.flag("json") ? Report::kJsonLine : Report::kSummary);
}

command_line::Command command_of(const Method& method) {
  std::vector<ParameterOption> options = parameters::parameter_options(method);
  command_line::Command command{command_name(method.name), without_full_stop(method.summary), {input_option()}, {}};
  for (const ParameterOption& parameter : options) command.options.push_back(parameter.option);
  for (Option& option : file_options()) command.options.push_back(std::move(option));
  if (!limits_time_itself(options)) {
    command.options.push_back(time_option("result"));
  }
  if (command.name == "nest") command.options.push_back(sheets_option());
  command.options.push_back(json_option());
  command.examples = examples_of(command.name);
  command.run = [name = method.name, options = std::move(options)](const command_line::Values& values) {
    return run_motion(name, options, values);
  };
  return command;
}

}  // namespace

std::vector<command_line::Command> motion_commands() {
  std::vector<command_line::Command> commands;
  for (const Method& method : protocol::methods::method_table().all()) {
    if (method.motion && method.name != kRemake) commands.push_back(command_of(method));
  }
  return commands;
}

}  // namespace selvage::cli::commands::motions
