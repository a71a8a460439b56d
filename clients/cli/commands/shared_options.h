// Options that several commands share: the marker's files, how to draw it, and the daemon to run on.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/command_line/option.h"
#include "clients/cli/command_line/values.h"
#include "clients/cli/commands/drawing.h"
#include "clients/cli/run/server_choice.h"
#include "clients/cli/terminal/failure.h"
#include "core/base/result.h"
#include "protocol/edits/cloth.h"
#include "protocol/files/file_format.h"

namespace selvage::cli::commands {

// What the command line says of a marker in place of its file.
struct MarkerOverrides {
  std::optional<double> spacing, overlap;                          // in the marker's unit
  Result<protocol::edits::Cloth> cloth{protocol::edits::Cloth{}};  // an error when the options cannot be read
};

// Where the marker of a command comes from, where the results go and where the command runs.
struct MarkerFiles {
  std::string in;
  std::string out, svg, outlines;                     // empty: not written
  std::optional<protocol::files::FileFormat> format;  // of `out`; none: by its suffix
  MarkerOverrides overrides;                          // of `in`
  Overlays overlays;                                  // of `svg`
  std::size_t threads{1};                             // of this process
  run::ServerChoice server;
};

// IN, the marker, as a positional argument.
[[nodiscard]] command_line::Option input_option();
// --out, --svg, --arrows, --chain, --outlines, --format, --threads, and those of override_options.
[[nodiscard]] std::vector<command_line::Option> file_options();
// --spacing, --overlap, and those of cloth's rules (clients/cli/parameters/cloth_options.h).
[[nodiscard]] std::vector<command_line::Option> override_options();
// --time; `what` is returned when it is over.
[[nodiscard]] command_line::Option time_option(const std::string& what);
[[nodiscard]] command_line::Option json_option();
// --server, --token-file, --trust: options of the program, valid for every command.
[[nodiscard]] std::vector<command_line::Option> server_options();

// REQUIRES: the values have the options above; `input_key` is the option that names the marker.
[[nodiscard]] MarkerFiles marker_files(const command_line::Values& values, const std::string& input_key);
[[nodiscard]] MarkerOverrides marker_overrides(const command_line::Values& values);
// The file with what was given in its place.  Errors: its own, and those of with_spacing, with_overlap and with_cloth.
[[nodiscard]] Result<MarkerFile> overridden(Result<MarkerFile> file, const MarkerOverrides& by);
[[nodiscard]] run::ServerChoice server_choice(const command_line::Values& values);

// How many files of results are standard output.
[[nodiscard]] int standard_outputs(const MarkerFiles& files);
// At most one of them may be, and all must be writable.
[[nodiscard]] std::optional<terminal::Failure> check_outputs(const MarkerFiles& files);

// Before the work: why one of these files cannot be written; empty names count as none.
[[nodiscard]] std::optional<terminal::Failure> check_writable(const std::vector<std::string>& paths);

// REQUIRES: `name` is one of protocol::files::kFileFormatNames.
[[nodiscard]] protocol::files::FileFormat format_named(const std::string& name);

}  // namespace selvage::cli::commands
