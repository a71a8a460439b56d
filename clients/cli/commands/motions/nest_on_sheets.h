// selvage nest --sheets: nests the pieces on sheets of given sizes, and writes each sheet to a file of its own.
#pragma once

#include "clients/cli/command_line/option.h"
#include "clients/cli/command_line/values.h"
#include "clients/cli/commands/shared_options.h"
#include "clients/cli/terminal/exit_code.h"
#include "protocol/json/json_text.h"

namespace selvage::cli::commands::motions {

[[nodiscard]] command_line::Option sheets_option();

// `params` are those of marker.nest; those that concern a single strip are refused.  The names of the sheets' files
// contain their numbers: "laid-1.json", "laid-2.json" for "laid.json".
[[nodiscard]] terminal::ExitCode nest_on_sheets(Json params, const MarkerFiles& files,
                                                const command_line::Values& values);

}  // namespace selvage::cli::commands::motions
