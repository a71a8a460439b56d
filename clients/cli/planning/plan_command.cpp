// selvage plan: plans markers, lays and plies for an order of a style, and writes the plan as text, JSON and HTML.
#include "clients/cli/planning/plan_command.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "clients/cli/commands/shared_options.h"
#include "clients/cli/library/folder.h"
#include "clients/cli/parameters/parameter_options.h"
#include "clients/cli/run/local.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/interrupt.h"
#include "protocol/calls/choices.h"
#include "protocol/execution/thread_pool.h"
#include "protocol/execution/time_limit.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/method_table.h"
#include "protocol/plans/plan_page.h"
#include "protocol/plans/plan_text.h"
#include "protocol/trade/orders/order.h"

namespace selvage::cli::planning {
namespace {

using command_line::Kind;
using command_line::Option;
using parameters::ParameterOption;
using terminal::ExitCode;

constexpr std::string_view kPlanMethod = "plan.cut";
// Parameters that the command sets itself.
constexpr std::array<std::string_view, 7> kGiven{"markerId",  "quantities", "remnants",     "stored",
                                                 "documents", "deadlineMs", "progressToken"};

const protocol::calls::Method& plan_method() {
  return *protocol::methods::find_method(kPlanMethod);
}

std::vector<ParameterOption> plan_options() {
  std::vector<ParameterOption> options = parameters::parameter_options(plan_method());
  std::erase_if(options, [](const ParameterOption& option) {
    return std::find(kGiven.begin(), kGiven.end(), option.parameter.name) != kGiven.end();
  });
  return options;
}

// One garment of each of the order's sizes.
Result<MarkerFile> load_style(const command_line::Values& values, std::string order) {
  protocol::trade::ReadingOptions options;
  options.order = std::move(order);
  options.one_of_each_size = true;
  options.width = values.number("width");
  if (const std::string rules = values.text("rules"); !rules.empty()) {
    auto text = terminal::read_text(rules);
    if (!text) return text.error();
    options.rules = *std::move(text);
  }
  return terminal::load_marker(values.text("style"), options);
}

// "red=3400,red=1200" as a list of remnants.
Result<Json> remnants_in(const std::string& text) {
  Json remnants = Json::array();
  std::stringstream entries{text};
  for (std::string entry; std::getline(entries, entry, ',');) {
    const auto sign = std::min(entry.rfind('='), entry.size());
    const std::string number = entry.substr(std::min(sign + 1, entry.size()));
    double length = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), length);
    if (sign == 0 || read.ec != std::errc{} || read.ptr != number.data() + number.size()) {
      return Error{ErrorCode::kOutOfRange,
                   "--remnants: " + protocol::json::shortened(Json(entry)) +
                       " is not a remnant; COLOUR=LENGTH is allowed, separated by commas",
                   ""};
    }
    Json one = Json::object();
    one["colour"] = entry.substr(0, sign);
    one["length"] = length;
    remnants.push_back(std::move(one));
  }
  return remnants;
}

// The markers of the library that are most similar to the style.
Result<Json> stored_near(const std::string& folder, const Marker& style) {
  const auto stored = library::list_folder(folder);
  if (!stored) return stored.error();
  const auto near = library::nearest_in(*stored, style, library::kConsidered);
  if (!near) return near.error();
  return library::documents_of(*near);
}

Result<Json> plan_params(const command_line::Values& values, const protocol::trade::orders::Order& order,
                         const Marker& style) {
  auto params = parameters::params_from(plan_options(), values);
  if (!params) return params;
  (*params)["markerId"] = run::kMarkerId;
  Json quantities = Json::array();
  for (const auto& [colour, size, garments] : order.quantities) {
    Json one = Json::object();
    one["colour"] = colour.empty() ? "cloth" : colour;
    one["size"] = size;
    one["garments"] = garments;
    quantities.push_back(std::move(one));
  }
  (*params)["quantities"] = std::move(quantities);
  if (const std::string given = values.text("remnants"); !given.empty()) {
    auto remnants = remnants_in(given);
    if (!remnants) return remnants;
    (*params)["remnants"] = *std::move(remnants);
  }
  if (const std::string folder = values.text("library"); !folder.empty()) {
    auto stored = stored_near(folder, style);
    if (!stored) return stored;
    (*params)["stored"] = *std::move(stored);
  }
  if (const auto seconds = values.number("time")) (*params)["deadlineMs"] = 1000 * *seconds;
  return params;
}

std::variant<run::Outcome, terminal::Failure> run_plan(const run::Invocation& invocation,
                                                       const command_line::Values& values) {
  const auto begin = protocol::execution::TimeLimit::Clock::now();
  const terminal::Interrupt interrupt;
  const bool show = !values.flag("json") && isatty(STDERR_FILENO) != 0;
  terminal::ProgressLine progress{invocation.file.marker, show, values.number("time")};
  if (const auto server = commands::server_choice(values))
    return run_remotely(server, invocation, interrupt.token(), progress);
  std::optional<std::chrono::duration<double>> seconds;
  if (const auto& ms = invocation.call.about.deadline_ms) seconds = std::chrono::duration<double, std::milli>{*ms};
  const protocol::execution::TimeLimit limit{interrupt.token(), begin, seconds};
  const auto threads = static_cast<std::size_t>(values.integer("threads").value_or(1));
  return run_locally(invocation, protocol::execution::ThreadPool{threads - 1}, limit, progress);
}

std::optional<Error> write_plan(const Json& plan, const command_line::Values& values, const std::string& title) {
  if (const std::string out = values.text("out"); !out.empty()) {
    if (auto error = terminal::write_text(out, protocol::json::to_text(plan, protocol::json::Layout::kIndented) + "\n"))
      return error;
  }
  const std::string html = values.text("html");
  if (html.empty()) return std::nullopt;
  const auto page = protocol::plans::plan_page(plan, title);
  if (!page) return page.error();
  return terminal::write_text(html, *page);
}

// Reads the order in this file.
Result<protocol::trade::orders::Order> order_in(const std::string& text, const std::string& path) {
  auto order = protocol::trade::orders::read_order(text);
  if (order) order = one_of_each_size(*std::move(order));
  if (order) return order;
  return Error{order.error().code, path + ": " + protocol::json::describe(order.error()), ""};
}

// The notes of both files.  Those of the order are among those of a style whose pieces it chose.
std::vector<Note> notes_of(const protocol::trade::orders::Order& order, const MarkerFile& style) {
  std::vector<Note> notes;
  for (const Note& note : order.notes) {
    const auto same = [&](const Note& other) { return other.text == note.text; };
    if (std::ranges::none_of(style.notes, same))
      notes.push_back({note.field.empty() ? "" : "/order" + note.field, note.text});
  }
  notes.insert(notes.end(), style.notes.begin(), style.notes.end());
  return notes;
}

ExitCode run_plan_command(const command_line::Values& values) {
  std::vector<commands::NamedFile> read = commands::files_of(commands::server_choice(values));
  for (const char* const option : {"ORDER", "--style", "--rules"})
    read.push_back({option, values.text(std::string_view{option}.substr(*option == '-' ? 2 : 0))});
  const std::vector<commands::NamedFile> written{{"--out", values.text("out")}, {"--html", values.text("html")}};
  if (const auto failure = commands::check_files(read, written)) return report(*failure);
  const auto text = terminal::read_text(values.text("ORDER"));
  if (!text) return terminal::report(text.error());
  const auto order = order_in(*text, values.text("ORDER"));
  if (!order) return terminal::report(order.error());
  const auto style = load_style(values, *text);
  if (!style) return terminal::report(style.error());
  auto params = plan_params(values, *order, style->marker);
  if (!params) return terminal::report(params.error());
  const auto call = plan_method().read(*params);
  if (!call) return terminal::report(call.error());
  terminal::print_notes(notes_of(*order, *style));
  const auto done = run_plan({plan_method(), *params, *call, *style}, values);
  if (const auto* failure = std::get_if<terminal::Failure>(&done)) return terminal::report(*failure);
  const Json& plan = std::get<run::Outcome>(done).fields;
  const bool to_output =
      values.text("out") == terminal::kStandardStream || values.text("html") == terminal::kStandardStream;
  (to_output ? std::cerr : std::cout) << (values.flag("json") ? protocol::json::to_text(plan) + "\n"
                                                              : protocol::plans::plan_text(plan))
                                      << std::flush;
  const std::string title = "Plan" + (order->id.empty() ? std::string{} : " of order " + order->id);
  if (const auto error = write_plan(plan, values, title)) return terminal::report(*error);
  const bool cancelled = plan["stop"] == protocol::schema::word_of(protocol::calls::StopCause::kCancelled);
  return cancelled ? ExitCode::kCancelled : ExitCode::kOk;
}

}  // namespace

command_line::Command plan_command() {
  command_line::Command command{
      "plan",
      "Plans which markers to cut for an order, with how many plies of which colour",
      {{.name = "ORDER",
        .kind = Kind::kText,
        .meaning = "Order (JSON or CSV): garments by colour and size",
        .required = true},
       {.name = "--style",
        .kind = Kind::kText,
        .meaning = "Pattern file, or a marker with one garment of every size",
        .required = true,
        .placeholder = "FILE"},
       {.name = "--rules",
        .kind = Kind::kText,
        .meaning = "Grade rule table (.rul) from which the sizes are made",
        .placeholder = "FILE"},
       {.name = "--width",
        .kind = Kind::kNumber,
        .meaning = "Width of the cloth in mm, when neither the order nor the style states it; default: 1500",
        .range = command_line::Range{1, 1e6}},
       {.name = "--remnants",
        .kind = Kind::kText,
        .meaning = "Lengths of cloth left over from earlier orders, in mm: COLOUR=LENGTH, separated by commas",
        .placeholder = "LIST"},
       {.name = "--library",
        .kind = Kind::kText,
        .meaning = "Folder of stored markers, from which the lengths of similar markers are first estimated",
        .placeholder = "FOLDER"}},
      &run_plan_command};
  for (ParameterOption& option : plan_options()) command.options.push_back(std::move(option.option));
  for (Option& option : commands::file_options()) {
    if (option.name == "--threads") command.options.push_back(std::move(option));
  }
  command.options.push_back(commands::time_option("plan"));
  command.options.push_back(
      {.name = "-o,--out", .kind = Kind::kText, .meaning = "JSON file to write the plan to", .placeholder = "FILE"});
  command.options.push_back({.name = "--html",
                             .kind = Kind::kText,
                             .meaning = "Page to write, with a picture of every marker",
                             .placeholder = "FILE"});
  command.options.push_back(commands::json_option());
  command.examples = {"selvage plan order.csv --style style.dxf --rules style.rul --html plan.html",
                      "selvage plan order.json --style sizes.json --plies 80 --spread face_to_face -o plan.json",
                      "selvage plan order.csv --style sizes.json --roll-length 60000 --remnants white=3400,navy=5200"};
  return command;
}

}  // namespace selvage::cli::planning
