// selvage convert and selvage show: write a marker, unchanged, in another format.
#include <iostream>
#include <string>

#include "clients/cli/commands/commands.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/run/remote.h"
#include "clients/cli/terminal/files.h"
#include "clients/cli/terminal/summary.h"

namespace selvage::cli::commands {
namespace {

using command_line::Kind;
using terminal::ExitCode;

std::variant<std::string, terminal::Failure> text_of(const MarkerFile& file, Format format,
                                                     const run::ServerChoice& server) {
  if (server) return run::text_remotely(server, file, format);
  auto text = protocol::formats::write_marker(file, format);
  if (!text) return terminal::failure_of(text.error());
  return *std::move(text);
}

ExitCode write_as(const MarkerFile& file, Format format, const std::string& path, const run::ServerChoice& server) {
  terminal::print_notes(file.notes);
  const auto text = text_of(file, format, server);
  if (const auto* failure = std::get_if<terminal::Failure>(&text)) return terminal::report(*failure);
  if (const auto error = terminal::write_text(path, std::get<std::string>(text))) return terminal::report(*error);
  return ExitCode::kOk;
}

ExitCode run_convert(const command_line::Values& values) {
  const auto file = terminal::load_marker(values.text("IN"));
  if (!file) return terminal::report(file.error());
  return write_as(*file, format_named(values.text("format")), values.text("out"), server_choice(values));
}

ExitCode run_show(const command_line::Values& values) {
  const auto file = terminal::load_marker(values.text("IN"));
  if (!file) return terminal::report(file.error());
  const std::string path = values.text("svg");
  const ExitCode code = write_as(*file, Format::kSvg, path, server_choice(values));
  if (code == ExitCode::kOk && path != terminal::kStandardStream)
    std::cout << terminal::plain_figures(file->marker) << "\n";
  return code;
}

}  // namespace

command_line::Command convert_command() {
  return {"convert",
          "Convert a marker to another format",
          {input_option(),
           {.name = "-o,--out",
            .kind = Kind::kText,
            .meaning = "Write to this file; - writes standard output",
            .required = true},
           {.name = "--format",
            .kind = Kind::kText,
            .meaning = "Format to write",
            .required = true,
            .choices = {"native", "sparrow", "outlines", "svg"}}},
          &run_convert};
}

command_line::Command show_command() {
  return {"show",
          "Draw a marker as SVG",
          {input_option(),
           {.name = "--svg",
            .kind = Kind::kText,
            .meaning = "Write the drawing to this file; - writes standard output",
            .required = true}},
          &run_show};
}

}  // namespace selvage::cli::commands
