// The examples of motions in --help and on the manual page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli::commands::motions {

// Example command lines of the subcommand; empty if it has none.
[[nodiscard]] std::vector<std::string> examples_of(std::string_view command);

}  // namespace selvage::cli::commands::motions
