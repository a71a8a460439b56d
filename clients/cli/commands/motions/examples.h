// What --help and the manual page show of the motions at work.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli::commands::motions {

// Command lines of the subcommand; empty when it has none.
[[nodiscard]] std::vector<std::string> examples_of(std::string_view command);

}  // namespace selvage::cli::commands::motions
