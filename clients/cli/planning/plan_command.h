// The command `selvage plan`.
#pragma once

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::planning {

// selvage plan ORDER --style FILE: plan.cut with the garments of an order and the pieces of a style.
[[nodiscard]] command_line::Command plan_command();

}  // namespace selvage::cli::planning
