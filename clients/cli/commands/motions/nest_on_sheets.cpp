#include "clients/cli/commands/motions/nest_on_sheets.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "clients/cli/commands/marker_run.h"
#include "clients/cli/terminal/files.h"
#include "protocol/files/writing.h"
#include "protocol/formats/format.h"

namespace selvage::cli::commands::motions {
namespace {

using terminal::ExitCode;

constexpr std::string_view kBinsOfFile = "bins";

bool has_only(std::string_view text, std::string_view allowed) {
  return !text.empty() && text.find_first_not_of(allowed) == std::string_view::npos;
}

// Parses "1500x3000*4": width, length and number of sheets.
std::optional<Json> sheet_of_size(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos || text.size() > kLongest) return std::nullopt;
  const std::size_t star = std::min(text.find('*'), text.size());
  if (star < cross) return std::nullopt;
  const std::string width{text.substr(0, cross)}, length{text.substr(cross + 1, star - cross - 1)};
  const std::string count{star < text.size() ? text.substr(star + 1) : "1"};
  if (!has_only(width, "0123456789.") || !has_only(length, "0123456789.") || !has_only(count, "0123456789"))
    return std::nullopt;
  auto sheet = protocol::json::parse("{\"width\":" + width + ",\"length\":" + length + ",\"count\":" + count + "}");
  if (!sheet) return std::nullopt;
  return *std::move(sheet);
}

// "1500x3000*4,1200x800" as the parameter of the call.
std::optional<Json> sheets_of_sizes(std::string_view text) {
  Json sheets = Json::array();
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    auto sheet = sheet_of_size(text.substr(begin, end - begin));
    if (!sheet) return std::nullopt;
    sheets.push_back(*std::move(sheet));
    begin = end + 1;
  }
  return sheets;
}

std::variant<Json, terminal::Failure> sheets_of(const std::string& text) {
  if (text.starts_with('[')) {
    auto sheets = protocol::json::parse(text);
    if (!sheets) return terminal::failure_of(sheets.error());
    return *std::move(sheets);
  }
  if (auto sheets = sheets_of_sizes(text)) return *std::move(sheets);
  return terminal::bad_usage("--sheets: \"" + text +
                             "\" is neither a list of sizes such as 1500x3000*4,1200x800 nor JSON such as "
                             "[{\"width\":1500,\"length\":3000,\"count\":4}], nor the word bins");
}

// "laid.json" becomes "laid-2.json".
std::string numbered(const std::string& path, std::size_t number) {
  std::filesystem::path name{path};
  name.replace_filename(name.stem().string() + "-" + std::to_string(number) + name.extension().string());
  return name.string();
}

// The number N for which numbered(base, N) is this file.
std::optional<std::size_t> sheet_number(const std::string& path, const std::string& base) {
  const std::string stem = std::filesystem::path{path}.stem().string();
  const std::string digits = stem.substr(std::min(stem.rfind('-') + 1, stem.size()));
  constexpr std::size_t kMostDigits = 9;
  if (!has_only(digits, "0123456789") || digits.size() > kMostDigits) return std::nullopt;
  const std::size_t number = std::stoul(digits);
  if (base.empty() || !terminal::name_one_file(numbered(base, number), path)) return std::nullopt;
  return number;
}

// A sheet with a part of the pieces must not replace the file with all of them.
std::optional<terminal::Failure> check_sheet_names(const MarkerFiles& files) {
  for (const auto& [option, base] :
       {std::pair{"--out", files.out}, {"--svg", files.svg}, {"--outlines", files.outlines}}) {
    const auto number = sheet_number(files.in.path, base);
    if (!number) continue;
    return terminal::bad_usage("sheet " + std::to_string(*number) + " of " + option + " would overwrite " +
                               files.in.path + ", which " + files.in.option + " reads");
  }
  return std::nullopt;
}

std::optional<Error> save_sheet(const MarkerFile& sheet, std::size_t number, const MarkerFiles& files) {
  if (!files.out.empty()) {
    const auto of_sheet = protocol::files::file_format(sheet.format);
    const auto by_name = protocol::files::format_of_name(files.out, of_sheet);
    const auto format = files.format.value_or(by_name.value_or(of_sheet));
    if (auto error = terminal::save_marker(numbered(files.out, number), sheet, format)) return error;
  }
  if (!files.outlines.empty()) {
    const std::string path = numbered(files.outlines, number);
    if (auto error = terminal::save_marker(path, sheet, protocol::files::FileFormat::kOutlines)) return error;
  }
  if (files.svg.empty()) return std::nullopt;
  return terminal::write_text(numbered(files.svg, number),
                              protocol::drawing::to_svg(sheet.marker, protocol::drawing::svg_options(sheet)));
}

// A file of the next number would be taken for one of this run.
void warn_of_earlier(const MarkerFiles& files, std::size_t sheets) {
  for (const std::string& base : {files.out, files.svg, files.outlines}) {
    if (base.empty()) continue;
    const std::string next = numbered(base, sheets + 1);
    std::error_code none;
    if (std::filesystem::exists(next, none)) std::cerr << "note: " << next << " is left from an earlier run\n";
  }
}

std::string summary_of(const std::string& name, const Json& fields) {
  const Json& sheets = fields["sheets"];
  std::string text = (name.empty() ? "marker" : name) + ": " + std::to_string(sheets.size()) +
                     (sheets.size() == 1 ? " sheet\n" : " sheets\n");
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    char line[160];
    std::snprintf(line, sizeof line, "  sheet %-3zu    kind %zu, %zu pieces, utilisation %.2f %%\n", k + 1,
                  sheets[k]["sheet"].get<std::size_t>() + 1, sheets[k]["pieces"].get<std::size_t>(),
                  100 * sheets[k]["utilisation"].number());
    text += line;
  }
  const double cost = fields["cost"].number();
  if (cost != static_cast<double>(sheets.size())) text += "  cost         " + protocol::json::number_text(cost) + "\n";
  const Json& left_over = fields["leftOver"];
  if (left_over.empty()) return text;
  constexpr std::size_t kNamed = 10;
  text += "  left over    " + std::to_string(left_over.size()) + (left_over.size() == 1 ? " piece: " : " pieces: ");
  for (std::size_t k = 0; k < std::min(kNamed, left_over.size()); ++k) {
    text += (k == 0 ? "" : ", ") + left_over[k].get<std::string>();
  }
  return text + (left_over.size() > kNamed ? ", ...\n" : "\n");
}

}  // namespace

command_line::Option sheets_option() {
  return {.name = "--sheets",
          .kind = command_line::Kind::kText,
          .meaning =
              "Nest on sheets of these sizes instead, WIDTHxLENGTH*COUNT,...; or the sheets of marker.nestSheets as "
              "JSON; or the word bins for those of a jagua-rs instance.  Every sheet that is used is written to a file "
              "with its number in the name",
          .placeholder = "SIZES"};
}

ExitCode nest_on_sheets(Json params, const MarkerFiles& files, const command_line::Values& values) {
  if (params.value("searches", 1.0) != 1 || params.value("keepPlaced", false) || params.value("fromScratch", false) ||
      files.overlays.arrows || files.overlays.critical_path) {
    return report(terminal::bad_usage(
        "--sheets cannot be combined with --searches, --keep-placed, --from-scratch, --arrows, --chain"));
  }
  for (const char* const parameter : {"searches", "keepPlaced", "fromScratch"}) params.erase(parameter);
  if (standard_outputs(files) > 0) {
    return report(terminal::bad_usage("with --sheets there may be several results, which cannot be standard output"));
  }
  if (const auto failure = check_sheet_names(files)) return report(*failure);
  if (const std::string& text = values.text("sheets"); text != kBinsOfFile) {
    auto sheets = sheets_of(text);
    if (const auto* failure = std::get_if<terminal::Failure>(&sheets)) return report(*failure);
    params["sheets"] = std::get<Json>(std::move(sheets));
  }
  const bool json = values.flag("json");
  const auto ran =
      run_method("marker.nestSheets", std::move(params), files, json ? Report::kJsonLine : Report::kSummary);
  if (const auto* code = std::get_if<ExitCode>(&ran)) return *code;
  const auto& [file, outcome] = std::get<MethodRun>(ran);

  Json fields = outcome.fields;
  for (std::size_t k = 0; k < fields["sheets"].size(); ++k) {
    auto sheet = protocol::formats::read_document(fields["sheets"][k]["marker"]);
    if (!sheet) return terminal::report(sheet.error());
    if (const auto error = save_sheet(*sheet, k + 1, files)) return terminal::report(*error);
    fields["sheets"][k].erase("marker");
  }
  warn_of_earlier(files, fields["sheets"].size());
  if (json) {
    Json left_over = std::move(fields["leftOver"]);
    fields.erase("leftOver");
    fields["left_over"] = std::move(left_over);
    std::cout << protocol::json::to_text(fields) << std::endl;
  } else {
    std::cout << summary_of(file.marker.name, fields) << std::flush;
  }
  return exit_code_of(outcome);
}

}  // namespace selvage::cli::commands::motions
