// The commands around a library of markers.
#pragma once

#include "clients/cli/command_line/parse.h"

namespace selvage::cli::library {

// selvage library add|list|search LIB FILE...
[[nodiscard]] command_line::Command library_command();
// selvage remake ORDER --library LIB: marker.remake with the nearest markers of the library.
[[nodiscard]] command_line::Command remake_command();

}  // namespace selvage::cli::library
