// Cloth's rules as options of every command that reads a marker: --margin-below, --repeat-along, --shade and the others
// of protocol/edits/cloth.h, whose descriptor they follow.
#pragma once

#include <vector>

#include "clients/cli/command_line/option.h"
#include "clients/cli/command_line/values.h"
#include "core/base/result.h"
#include "protocol/edits/cloth.h"

namespace selvage::cli::parameters {

[[nodiscard]] std::vector<command_line::Option> cloth_options();
// The rules that were given.  Errors: those of reading a message from JSON, for options that are given as JSON.
[[nodiscard]] Result<protocol::edits::Cloth> cloth_from(const command_line::Values& values);

}  // namespace selvage::cli::parameters
