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

// Values that the command line sets in place of those of the marker's file.
struct MarkerOverrides {
  std::optional<double> spacing, overlap;                          // in the marker's unit
  Result<protocol::edits::Cloth> cloth{protocol::edits::Cloth{}};  // an error if the options cannot be read
};

// A file that a command reads or writes, and the option that names it.
struct NamedFile {
  std::string option, path;  // an empty path: the option was not given
};

// Where the marker of a command comes from, where the results go and where the command runs.
struct MarkerFiles {
  NamedFile in;
  std::string out, svg, outlines;                     // empty: not written
  std::optional<protocol::files::FileFormat> format;  // of `out`; if none, its suffix decides
  MarkerOverrides overrides;                          // for `in`
  Overlays overlays;                                  // for `svg`
  std::size_t threads{1};                             // of this process
  run::ServerChoice server;
};

// IN, the marker, as a positional argument.
[[nodiscard]] command_line::Option input_option();
// --out, --svg, --arrows, --chain, --outlines, --format, --threads, and those of override_options.
[[nodiscard]] std::vector<command_line::Option> file_options();
// --spacing, --overlap, and those of cloth's rules (clients/cli/parameters/cloth_options.h).
[[nodiscard]] std::vector<command_line::Option> override_options();
// --time; `what` is the kind of result that is returned when the time is over, such as "marker".
[[nodiscard]] command_line::Option time_option(const std::string& what);
[[nodiscard]] command_line::Option json_option();
// --server, --token-file, --trust: options of the program, valid for every command.
[[nodiscard]] std::vector<command_line::Option> server_options();

// REQUIRES: the values have the options above; `input_key` is the option that names the marker.
[[nodiscard]] MarkerFiles marker_files(const command_line::Values& values, const std::string& input_key);
[[nodiscard]] MarkerOverrides marker_overrides(const command_line::Values& values);
// Applies the overrides to the file.  Errors: that of `file`, and those of with_spacing, with_overlap and with_cloth.
[[nodiscard]] Result<MarkerFile> overridden(Result<MarkerFile> file, const MarkerOverrides& by);
[[nodiscard]] run::ServerChoice server_choice(const command_line::Values& values);

// The number of result files that are standard output.
[[nodiscard]] int standard_outputs(const MarkerFiles& files);
// Checks that at most one of them is standard output, that no two of them are one file, that none is a file that is
// read, and that all can be written.  The marker itself may take the place of the one that was read.  `also_read` are
// files that the command reads besides.
[[nodiscard]] std::optional<terminal::Failure> check_outputs(const MarkerFiles& files,
                                                             const std::vector<NamedFile>& also_read = {});
// Checks that at most one of the files is standard input.
[[nodiscard]] std::optional<terminal::Failure> check_inputs(const std::vector<NamedFile>& read);
// check_inputs, and the same as check_outputs for a command that writes other files.
[[nodiscard]] std::optional<terminal::Failure> check_files(const std::vector<NamedFile>& read,
                                                           const std::vector<NamedFile>& written);

// Whether the marker that is read and written back into its file keeps everything: what was drawn or planned for a
// machine cannot replace a marker.
[[nodiscard]] bool may_replace_input(const std::string& out, std::optional<protocol::files::FileFormat> format);
// The files that the choice of a daemon names.
[[nodiscard]] std::vector<NamedFile> files_of(const run::ServerChoice& server);

// REQUIRES: `name` is one of protocol::files::kFileFormatNames.
[[nodiscard]] protocol::files::FileFormat format_named(const std::string& name);

}  // namespace selvage::cli::commands
