// What the commands that run a method on a marker have in common: where the marker comes from and goes to,
// and the run itself, here or on a daemon (roads.h).
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "clients/cli/run/drawing.h"
#include "clients/cli/run/server_option.h"
#include "clients/cli/terminal/exit_code.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::run {

struct MarkerFiles {
  std::string in, out, svg, outlines;
  std::optional<std::string> format;
  std::optional<double> spacing;
  DrawingWish drawing;
  ServerChoice server;                                                     // where it runs
  std::size_t threads{std::max(1U, std::thread::hardware_concurrency())};  // when it runs here
};
// IN as the first argument.
void add_marker_in(CLI::App& command, MarkerFiles& files);
// -o, --svg, --arrows, --chain, --outlines, --format, --spacing, --threads.
void add_marker_files(CLI::App& command, MarkerFiles& files);
// Throws CLI::ValidationError when more than one is written to standard output.
void refuse_mixed_streams(const MarkerFiles& files);

// How the answer is told.
enum class Telling {
  kSummary,  // a few lines for people
  kLine,     // one line of JSON, its names in snake_case, with the times
  kResult    // the result as the daemon gives it
};

// Runs the method as a daemon would that has just opened the marker: as "m1", at revision 1.  What is not
// proved valid is not written, unless the call asks for it.  REQUIRES: marker_methods.h has the method, or it is
// marker.apply.
[[nodiscard]] terminal::ExitCode run_on_marker(std::string_view method, Json params, const MarkerFiles& files,
                                               Telling telling);

// The short form of a motion: its files and --json, and what it does when it is the command chosen.  Options have
// `files`, `json` and params(), the call's parameters.  REQUIRES: `method` is a literal.
template <class Options>
void add_motion(CLI::App& command, const std::shared_ptr<Options>& options, std::string_view method,
                terminal::ExitCode& code) {
  add_marker_files(command, options->files);
  command.add_flag("--json", options->json, "Print one line of JSON instead of the summary");
  command.footer(terminal::kExitCodesHelp);
  command.callback([options, method, &command, &code] {
    refuse_mixed_streams(options->files);
    options->files.server = server_choice(command);
    code = run_on_marker(method, options->params(), options->files, options->json ? Telling::kLine : Telling::kSummary);
  });
}

}  // namespace selvage::cli::run
