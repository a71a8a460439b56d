// The parts of an option's name: "-o,--out" is "-o" and "--out".
#pragma once

#include <string>
#include <vector>

#include "clients/cli/command_line/option.h"

namespace selvage::cli::documents {

[[nodiscard]] inline bool is_positional(const command_line::Option& option) {
  return !option.name.starts_with('-');
}

// Short names first.
[[nodiscard]] inline std::vector<std::string> names_of(const command_line::Option& option) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= option.name.size();) {
    const std::size_t end = std::min(option.name.find(',', at), option.name.size());
    names.push_back(option.name.substr(at, end - at));
    at = end + 1;
  }
  return names;
}

}  // namespace selvage::cli::documents
