// How options and their values are named to people, by --help and by the manual page alike.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/command_line/option.h"

namespace selvage::cli::command_line {

[[nodiscard]] bool is_positional(const Option& option);

// "-o,--out" is "-o" and "--out": short names first.
[[nodiscard]] std::vector<std::string> names_of(const Option& option);

// What stands for the option's value: its placeholder, its choices when there are few, or the kind of value; empty for
// a flag.
[[nodiscard]] std::string value_of(const Option& option);

// The meaning as sentences without the last full stop: also the choices that value_of leaves out, and the default
// unless the meaning states it.
[[nodiscard]] std::string meaning_of(const Option& option);

}  // namespace selvage::cli::command_line
