// Runs one method on one marker: reads the files, runs the method here or on a daemon, prints the result and writes the
// files.
#pragma once

#include <string_view>
#include <variant>

#include "clients/cli/commands/shared_options.h"
#include "clients/cli/run/invocation.h"
#include "clients/cli/terminal/exit_code.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::commands {

// What is printed about the result.
enum class Report {
  kSummary,   // a few lines for people
  kJsonLine,  // one line of JSON with names in snake_case, including the times
  kResult,    // the result as the daemon returns it
};

// Runs the method like a daemon that has just opened the marker: as "m1", at revision 1.  A marker that is not proved
// valid is not written, unless the call asks for it.  REQUIRES: the method table has the method; it works on one
// marker, or it is marker.apply.
[[nodiscard]] terminal::ExitCode run_on_marker(std::string_view method, Json params, const MarkerFiles& files,
                                               Report report);

// The same without the report and the files, for a command that prints and writes its results itself.
struct MethodRun {
  MarkerFile file;  // the marker that was read
  run::Outcome outcome;
};
[[nodiscard]] std::variant<MethodRun, terminal::ExitCode> run_method(std::string_view method, Json params,
                                                                     const MarkerFiles& files, Report report);
// kCancelled if the caller stopped the run, kNotValid if the resulting marker is not valid.
[[nodiscard]] terminal::ExitCode exit_code_of(const run::Outcome& outcome);

}  // namespace selvage::cli::commands
