#include "clients/cli/commands/shared_options.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <thread>

#include "clients/cli/parameters/cloth_options.h"
#include "clients/cli/terminal/files.h"
#include "protocol/files/writing.h"
#include "protocol/formats/format.h"

namespace selvage::cli::commands {

using command_line::Kind;
using command_line::Option;

Option input_option() {
  return {
      .name = "IN", .kind = Kind::kText, .meaning = "Marker or pattern file; - reads standard input", .required = true};
}

std::vector<Option> override_options() {
  std::vector<Option> options{
      {.name = "--spacing",
       .kind = Kind::kNumber,
       .meaning = "Minimum distance between pieces, in the marker's unit; overrides the marker's own",
       .placeholder = "LENGTH"},
      {.name = "--overlap",
       .kind = Kind::kNumber,
       .meaning = "Overlap allowance of the pieces, in the marker's unit; overrides the marker's own",
       .placeholder = "LENGTH"}};
  for (Option& option : parameters::cloth_options()) options.push_back(std::move(option));
  return options;
}

Option time_option(const std::string& what) {
  return {.name = "--time",
          .kind = Kind::kNumber,
          .meaning = "After this many seconds the best " + what + " so far is returned",
          .range = command_line::Range{0.001, 86'400},
          .placeholder = "SECONDS"};
}

Option json_option() {
  return {.name = "--json", .kind = Kind::kFlag, .meaning = "Print one line of JSON instead of the summary"};
}

std::vector<Option> file_options() {
  const std::int64_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<Option> options{
      {.name = "-o,--out",
       .kind = Kind::kText,
       .meaning = "Write the resulting marker to this file; - writes standard output",
       .placeholder = "FILE"},
      {.name = "--svg",
       .kind = Kind::kText,
       .meaning = "Write a drawing of the result to this file",
       .placeholder = "FILE"},
      {.name = "--arrows",
       .kind = Kind::kFlag,
       .meaning = "Draw the displacements of the pieces and the forces on them"},
      {.name = "--chain", .kind = Kind::kFlag, .meaning = "Draw the critical path, which determines the length"},
      {.name = "--outlines",
       .kind = Kind::kText,
       .meaning = "Write the placed outlines to this file, in exact coordinates",
       .placeholder = "FILE"},
      {.name = "--format",
       .kind = Kind::kText,
       .meaning = "Format of --out; default: by its suffix, else the format of the input",
       .choices = {std::begin(protocol::files::kFileFormatNames), std::end(protocol::files::kFileFormatNames)}},
      {.name = "--threads",
       .kind = Kind::kInteger,
       .meaning =
           "Number of threads, by default as many as there are cores; it does not affect the result, unless time is "
           "limited",
       .standard = cores,
       .range = command_line::Range{1, 256}},
  };
  for (Option& option : override_options()) options.push_back(std::move(option));
  return options;
}

std::vector<Option> server_options() {
  return {
      {.name = "--server",
       .kind = Kind::kText,
       .meaning = "Run on this daemon: HOST:PORT, tls://HOST:PORT or the path of a Unix socket",
       .placeholder = "ADDRESS"},
      {.name = "--token-file",
       .kind = Kind::kText,
       .meaning = "File whose first line is the daemon's token",
       .placeholder = "FILE"},
      {.name = "--trust",
       .kind = Kind::kText,
       .meaning = "With tls://: file of certificates (PEM) to trust instead of the system's",
       .placeholder = "FILE"},
  };
}

MarkerFiles marker_files(const command_line::Values& values, const std::string& input_key) {
  MarkerFiles files;
  files.in = {input_key == "marker" ? "--marker" : input_key, values.text(input_key)};
  files.out = values.text("out");
  files.svg = values.text("svg");
  files.outlines = values.text("outlines");
  if (values.find("format") != nullptr) files.format = format_named(values.text("format"));
  files.overrides = marker_overrides(values);
  files.overlays = {.arrows = values.flag("arrows"), .critical_path = values.flag("chain")};
  files.threads = static_cast<std::size_t>(values.integer("threads").value_or(1));
  files.server = server_choice(values);
  return files;
}

MarkerOverrides marker_overrides(const command_line::Values& values) {
  return {values.number("spacing"), values.number("overlap"), parameters::cloth_from(values)};
}

Result<MarkerFile> overridden(Result<MarkerFile> file, const MarkerOverrides& by) {
  if (file && by.spacing) file = protocol::formats::with_spacing(*std::move(file), *by.spacing);
  if (file && by.overlap) file = protocol::formats::with_overlap(*std::move(file), *by.overlap);
  if (!file) return file;
  if (!by.cloth) return by.cloth.error();
  return protocol::edits::with_cloth(*std::move(file), *by.cloth);
}

run::ServerChoice server_choice(const command_line::Values& values) {
  return {values.find("server") != nullptr, values.text("server"), values.text("token-file"), values.text("trust")};
}

int standard_outputs(const MarkerFiles& files) {
  return (files.out == terminal::kStandardStream) + (files.svg == terminal::kStandardStream) +
         (files.outlines == terminal::kStandardStream);
}

std::optional<terminal::Failure> check_outputs(const MarkerFiles& files, const std::vector<NamedFile>& also_read) {
  if (standard_outputs(files) > 1)
    return terminal::bad_usage("only one of --out, --svg, --outlines can be standard output");
  std::vector<NamedFile> read = files_of(files.server);
  read.insert(read.end(), also_read.begin(), also_read.end());
  std::vector<NamedFile> all = read;
  all.insert(all.begin(), files.in);
  const std::vector<NamedFile> others{{"--svg", files.svg}, {"--outlines", files.outlines}};
  std::vector<NamedFile> written = others;
  written.insert(written.begin(), {"--out", files.out});
  if (auto failure = check_files(all, others)) return failure;
  return check_files(may_replace_input(files.out, files.format) ? read : all, written);
}

std::optional<terminal::Failure> check_inputs(const std::vector<NamedFile>& read) {
  const NamedFile* first = nullptr;
  for (const NamedFile& input : read) {
    if (input.path != terminal::kStandardStream) continue;
    if (first != nullptr)
      return terminal::bad_usage("only one of " + first->option + " and " + input.option + " can be standard input");
    first = &input;
  }
  return std::nullopt;
}

std::optional<terminal::Failure> check_files(const std::vector<NamedFile>& read,
                                             const std::vector<NamedFile>& written) {
  if (auto failure = check_inputs(read)) return failure;
  for (auto one = written.begin(); one != written.end(); ++one) {
    if (one->path.empty()) continue;
    for (const NamedFile& input : read) {
      if (!terminal::name_one_file(one->path, input.path)) continue;
      return terminal::bad_usage(one->option + " would overwrite " + input.path + ", which " + input.option + " reads");
    }
    for (auto other = written.begin(); other != one; ++other) {
      if (!terminal::name_one_file(other->path, one->path)) continue;
      return terminal::bad_usage(other->option + " and " + one->option + " name the same file, " + one->path);
    }
    if (const auto error = terminal::why_not_writable(one->path)) return terminal::failure_of(*error);
  }
  return std::nullopt;
}

bool may_replace_input(const std::string& out, std::optional<protocol::files::FileFormat> format) {
  using protocol::files::FileFormat;
  const FileFormat written =
      format.value_or(protocol::files::format_of_name(out, FileFormat::kNative).value_or(FileFormat::kNative));
  return written == FileFormat::kNative || written == FileFormat::kSparrow;
}

std::vector<NamedFile> files_of(const run::ServerChoice& server) {
  return {{"--token-file", server.token_file}, {"--trust", server.trusted}};
}

protocol::files::FileFormat format_named(const std::string& name) {
  return *protocol::schema::value_of<protocol::files::FileFormat>(name);
}

}  // namespace selvage::cli::commands
