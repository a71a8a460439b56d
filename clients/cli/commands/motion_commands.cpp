// The short forms of motions: `selvage compact IN --rounds 5` is `selvage call motion.compact` with parameters from
// options.
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/marker_run.h"
#include "protocol/calls/motion.h"
#include "protocol/methods/motions/float.h"
#include "protocol/methods/motions/separate.h"

namespace selvage::cli::commands {
namespace {

using command_line::Kind;
using command_line::Option;
using command_line::Range;
using command_line::Value;

// An option that becomes a parameter of the motion.
struct Parameter {
  std::string name;
  Option option;
  double divisor{1};  // of a number: the parameter is the option's value divided by this
};

struct Motion {
  std::string command, method, summary;
  std::vector<Parameter> parameters;
};

template <std::size_t count>
std::vector<std::string> names_in(const std::string_view (&names)[count]) {
  return {std::begin(names), std::end(names)};
}

Parameter accuracy() {
  return {"accuracy",
          {.name = "--accuracy",
           .kind = Kind::kText,
           .meaning = "How much work to spend",
           .standard = "standard",
           .choices = names_in(protocol::calls::kAccuracyNames)}};
}

Motion compaction() {
  return {"compact",
          "motion.compact",
          "Shorten a marker by moving all pieces at once; no piece jumps over another",
          {accuracy(),
           {"rounds",
            {.name = "--rounds",
             .kind = Kind::kInteger,
             .meaning = "Maximum number of rounds",
             .range = Range{0, protocol::calls::kMaxRounds}}},
           {"simplification",
            {.name = "--simplification",
             .kind = Kind::kNumber,
             .meaning = "Pairs farther apart than this fraction of the width use simplified enclosing outlines",
             .range = Range{0, protocol::calls::kMostSimplification}}}}};
}

Motion bump() {
  return {"bump",
          "motion.bump",
          "Slide one piece as far as possible while all others stay in place",
          {{"piece", {.name = "--piece", .kind = Kind::kText, .meaning = "The piece's id", .required = true}},
           {"direction",
            {.name = "--direction",
             .kind = Kind::kNumbers,
             .meaning = "Direction to slide in, such as -1,0",
             .required = true,
             .count = 2,
             .placeholder = "X,Y"}}}};
}

Motion separation() {
  constexpr double kPerCent = 100;
  return {"separate",
          "motion.separate",
          "Separate overlapping pieces, moving all pieces as little as possible",
          {{"grow",
            {.name = "--grow",
             .kind = Kind::kNumber,
             .meaning = "How much longer the marker may become, in per cent",
             .standard = 0.0,
             .range = Range{0, protocol::methods::motions::kMostGrowth * kPerCent}},
            kPerCent},
           {"popOut",
            {.name = "--pop-out",
             .kind = Kind::kFlag,
             .meaning = "Leave out pieces that block the separation, and list them"}},
           {"partial",
            {.name = "--partial", .kind = Kind::kFlag, .meaning = "Write the result even if pieces still overlap"}}}};
}

Motion floating() {
  return {"float",
          "motion.float",
          "Distribute the free space over the gaps between pieces",
          {{"distance",
            {.name = "--distance",
             .kind = Kind::kNumber,
             .meaning = "Target gap, in the marker's unit; wider gaps count as this wide",
             .required = true}},
           {"mode",
            {.name = "--mode",
             .kind = Kind::kText,
             .meaning = "Objective",
             .standard = std::string{protocol::methods::motions::kFloatModeNames[0]},
             .choices = names_in(protocol::methods::motions::kFloatModeNames)}},
           {"edges", {.name = "--edges", .kind = Kind::kFlag, .meaning = "Include the gaps to the strip's edges"}}}};
}

Motion tilting() {
  return {"tilt",
          "motion.tilt",
          "Shorten a marker by moving and slightly rotating all pieces at once",
          {{"limit",
            {.name = "--limit",
             .kind = Kind::kNumber,
             .meaning = "Maximum tilt in degrees; overrides the limits of the shapes",
             .range = Range{0, 45}}},
           {"method",
            {.name = "--method",
             .kind = Kind::kText,
             .meaning = "All pieces at once (linearisation) or one after another (relaxation)",
             .standard = "linearisation",
             .choices = {"linearisation", "relaxation"}}},
           accuracy()}};
}

Json parameter_value(const Parameter& parameter, const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* number = std::get_if<double>(&value)) return *number / parameter.divisor;
  Json list = Json::array();
  for (const double number : std::get<std::vector<double>>(value)) list.push_back(number);
  return list;
}

Json params_of(const Motion& motion, const command_line::Values& values) {
  Json params = Json::object();
  for (const Parameter& parameter : motion.parameters) {
    if (const Value* const value = values.find(key_of(parameter.option)))
      params[parameter.name] = parameter_value(parameter, *value);
  }
  return params;
}

terminal::ExitCode run_motion(const Motion& motion, const command_line::Values& values) {
  const MarkerFiles files = marker_files(values, "IN");
  if (const auto failure = check_outputs(files)) return report(*failure);
  return run_on_marker(motion.method, params_of(motion, values), files,
                       values.flag("json") ? Report::kJsonLine : Report::kSummary);
}

command_line::Command command_of(Motion motion) {
  command_line::Command command{motion.command, motion.summary, {input_option()}, {}};
  for (const Parameter& parameter : motion.parameters) command.options.push_back(parameter.option);
  for (Option& option : file_options()) command.options.push_back(std::move(option));
  command.options.push_back(
      {.name = "--json", .kind = Kind::kFlag, .meaning = "Print one line of JSON instead of the summary"});
  command.run = [motion = std::move(motion)](const command_line::Values& values) { return run_motion(motion, values); };
  return command;
}

}  // namespace

std::vector<command_line::Command> motion_commands() {
  std::vector<command_line::Command> commands;
  for (Motion motion : {compaction(), bump(), separation(), floating(), tilting()})
    commands.push_back(command_of(std::move(motion)));
  return commands;
}

}  // namespace selvage::cli::commands
