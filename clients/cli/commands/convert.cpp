// selvage convert and selvage show: write a marker, unchanged, in another format.
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/summary.h"
#include "protocol/files/losses.h"
#include "protocol/files/writing.h"
#include "protocol/plots/cut_file.h"

namespace selvage::cli::commands {
namespace {

namespace trade = protocol::trade;
using command_line::Kind;
using protocol::files::FileFormat;
using terminal::ExitCode;

std::variant<std::string, terminal::Failure> text_of(const MarkerFile& file, FileFormat format,
                                                     const run::ServerChoice& server) {
  if (server) return run::text_remotely(server, file, protocol::schema::word_of(format));
  auto text = protocol::files::write_marker(file, format);
  if (!text) return terminal::failure_of(text.error());
  return *std::move(text);
}

ExitCode write_as(const MarkerFile& file, FileFormat format, const std::string& path, const run::ServerChoice& server) {
  terminal::print_notes(file.notes);
  const auto text = text_of(file, format, server);
  if (const auto* failure = std::get_if<terminal::Failure>(&text)) return terminal::report(*failure);
  if (const auto error = terminal::write_text(path, std::get<std::string>(text))) return terminal::report(*error);
  terminal::print_notes(protocol::files::losses(file, format));
  return ExitCode::kOk;
}

// The enumerator whose word was given; the first one if the option was not given.
template <class Enum, std::size_t N>
Enum choice_of(const command_line::Values& values, const char* key, const std::string_view (&words)[N]) {
  const auto* const found = std::find(std::begin(words), std::end(words), values.text(key));
  return found == std::end(words) ? Enum{} : static_cast<Enum>(found - std::begin(words));
}

std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    if (end > from) parts.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

Result<trade::ReadingOptions> reading_options(const command_line::Values& values) {
  trade::ReadingOptions options;
  if (values.find("unit") != nullptr) options.unit = choice_of<trade::LengthUnit>(values, "unit", trade::kUnitWords);
  options.tolerance = values.number("tolerance").value_or(options.tolerance);
  options.fold = choice_of<trade::FoldRule>(values, "fold", trade::kFoldWords);
  options.nap = choice_of<trade::Nap>(values, "nap", trade::kNapWords);
  options.width = values.number("width");
  options.sizes = listed(values.text("sizes"));
  options.plain = values.flag("plain");
  for (const auto& [key, kept] : {std::pair{"rules", &options.rules}, {"order", &options.order}}) {
    const std::string path = values.text(key);
    if (path.empty()) continue;
    auto text = terminal::read_text(path);
    if (!text) return text.error();
    *kept = *std::move(text);
  }
  return options;
}

// The file to write: OUT, or the value of the option.
std::optional<std::string> output_of(const command_line::Values& values, const char* key) {
  const std::string second = values.text("OUT"), option = values.text(key);
  if (second.empty() == option.empty()) return std::nullopt;
  return second.empty() ? option : second;
}

void report_travel(const MarkerFile& file) {
  const auto cut = protocol::plots::cut_file(protocol::plots::sheet_of(file));
  std::cerr << "note: the knife travels " << protocol::plots::thousandths(cut.travel / 1000)
            << " m between pieces; in the marker's order it would be "
            << protocol::plots::thousandths(cut.travel_in_order / 1000) << " m\n";
}

// The name of the file to write and the option that gives it.
NamedFile written_by(const command_line::Values& values, const char* key, const std::string& path) {
  return {values.text("OUT").empty() ? "--" + std::string{key} : "OUT", path};
}

// Checks that OUT replaces no file that is read, except a marker by the same marker.
std::optional<terminal::Failure> check_convert_output(const command_line::Values& values, const std::string& out) {
  std::optional<FileFormat> format;
  if (values.find("format") != nullptr) format = format_named(values.text("format"));
  std::vector<NamedFile> read = files_of(server_choice(values));
  read.push_back({"--rules", values.text("rules")});
  read.push_back({"--order", values.text("order")});
  std::vector<NamedFile> all = read;
  all.insert(all.begin(), {"IN", values.text("IN")});
  if (auto failure = check_inputs(all)) return failure;
  return check_files(may_replace_input(out, format) ? read : all, {written_by(values, "out", out)});
}

ExitCode run_convert(const command_line::Values& values) {
  const auto out = output_of(values, "out");
  if (!out) return terminal::report(terminal::bad_usage("name one file to write: OUT, or --out OUT"));
  if (const auto failure = check_convert_output(values, *out)) return report(*failure);
  const auto options = reading_options(values);
  if (!options) return terminal::report(options.error());
  const auto file = overridden(terminal::load_marker(values.text("IN"), *options), marker_overrides(values));
  if (!file) return terminal::report(file.error());
  const auto format = values.find("format") != nullptr
                          ? std::optional{format_named(values.text("format"))}
                          : protocol::files::format_of_name(*out, protocol::files::file_format(file->format));
  if (!format) return terminal::report(terminal::bad_usage(*out + " has no suffix of a known format; give --format"));
  const ExitCode code = write_as(*file, *format, *out, server_choice(values));
  if (code == ExitCode::kOk && *format == FileFormat::kCut) report_travel(*file);
  return code;
}

// The drawing goes to standard output if no file is named, unless that is a terminal.
ExitCode run_show(const command_line::Values& values) {
  const bool named = !values.text("OUT").empty() || !values.text("svg").empty();
  const bool readable = !named && isatty(STDOUT_FILENO) == 0;
  const auto out = readable ? std::string{terminal::kStandardStream} : output_of(values, "svg");
  if (!out) return terminal::report(terminal::bad_usage("name one file to write: OUT, or --svg OUT"));
  const std::string& path = *out;
  std::vector<NamedFile> read = files_of(server_choice(values));
  read.push_back({"IN", values.text("IN")});
  if (const auto failure = check_files(read, {written_by(values, "svg", path)})) return report(*failure);
  const auto file = terminal::load_marker(values.text("IN"));
  if (!file) return terminal::report(file.error());
  const ExitCode code = write_as(*file, FileFormat::kSvg, path, server_choice(values));
  if (code == ExitCode::kOk && path != terminal::kStandardStream)
    std::cout << terminal::plain_figures(file->marker) << "\n";
  return code;
}

std::vector<command_line::Option> convert_options() {
  using trade::kFoldWords, trade::kNapWords, trade::kUnitWords;
  const auto& formats = protocol::files::kFileFormatNames;
  return {input_option(),
          {.name = "OUT", .kind = Kind::kText, .meaning = "File to write; - writes standard output"},
          {.name = "-o,--out", .kind = Kind::kText, .meaning = "The same as OUT", .placeholder = "FILE"},
          {.name = "--format",
           .kind = Kind::kText,
           .meaning = "Format to write; default: by the suffix of OUT",
           .choices = {std::begin(formats), std::end(formats)}},
          {.name = "--unit",
           .kind = Kind::kText,
           .meaning = "Unit of a pattern or cut file, instead of the one it states",
           .choices = {std::begin(kUnitWords), std::end(kUnitWords)}},
          {.name = "--width",
           .kind = Kind::kNumber,
           .meaning = "Width of the cloth in mm, which a pattern file does not state; default: 1500",
           .range = command_line::Range{1, 1e6},
           .placeholder = "LENGTH"},
          {.name = "--sizes",
           .kind = Kind::kText,
           .meaning = "Sizes of a graded style, separated by commas; default: all",
           .placeholder = "SIZE,..."},
          {.name = "--rules",
           .kind = Kind::kText,
           .meaning = "Grade rule table (.rul) from which the sizes are made",
           .placeholder = "FILE"},
          {.name = "--order",
           .kind = Kind::kText,
           .meaning = "Order (JSON or CSV) that lists the garments to cut",
           .placeholder = "FILE"},
          {.name = "--fold",
           .kind = Kind::kText,
           .meaning =
               "Unfold half pieces about their mirror line, keep them as drawn, or lay them on the fold of the cloth, "
               "where other pieces are cut as pairs; default: unfold",
           .choices = {std::begin(kFoldWords), std::end(kFoldWords)}},
          {.name = "--nap",
           .kind = Kind::kText,
           .meaning = "Whether pieces of a pattern may also lie turned by 180 degrees; default: one_way",
           .choices = {std::begin(kNapWords), std::end(kNapWords)}},
          {.name = "--tolerance",
           .kind = Kind::kNumber,
           .meaning = "How far a flattened curve may lie from the true one, in mm; default: 0.05",
           .range = command_line::Range{1e-4, 100},
           .placeholder = "LENGTH"},
          {.name = "--plain", .kind = Kind::kFlag, .meaning = "Read every closed outline of a DXF as a piece"}};
}

}  // namespace

command_line::Command convert_command() {
  std::vector<command_line::Option> options = convert_options();
  for (command_line::Option& option : override_options()) options.push_back(std::move(option));
  return {"convert",
          "Converts a marker or a pattern file to another format",
          std::move(options),
          &run_convert,
          {"selvage convert style.dxf order.json --rules style.rul --sizes S,M,L",
           "selvage convert marker.json marker.pdf", "selvage convert marker.json marker.cut"}};
}

command_line::Command show_command() {
  return {"show",
          "Draws a marker as SVG",
          {input_option(),
           {.name = "OUT",
            .kind = Kind::kText,
            .meaning = "File to write; when absent, standard output, unless that is a terminal"},
           {.name = "--svg", .kind = Kind::kText, .meaning = "The same as OUT", .placeholder = "FILE"}},
          &run_show,
          {"selvage show marker.json marker.svg"}};
}

}  // namespace selvage::cli::commands
