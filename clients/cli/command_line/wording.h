// The texts by which --help and the manual page describe options and their values.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/command_line/option.h"

namespace selvage::cli::command_line {

[[nodiscard]] bool is_positional(const Option& option);

// "-o,--out" is "-o" and "--out": short names first.
[[nodiscard]] std::vector<std::string> names_of(const Option& option);

// The placeholder of the option's value: the given one, the choices if there are few, or the kind of value; empty for a
// flag.
[[nodiscard]] std::string value_of(const Option& option);

// The meaning as sentences without the last full stop.  It includes the choices that value_of leaves out, and the
// default unless the meaning states it already.
[[nodiscard]] std::string meaning_of(const Option& option);

}  // namespace selvage::cli::command_line
