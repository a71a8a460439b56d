// Options of reading that do not matter for the file that was read.
#pragma once

#include <string_view>
#include <vector>

#include "protocol/document/marker_file.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::files {

// A note for each option that was given and is not among `used`, names separated by blanks, or that another option
// decides.  `what`: the kind of file, such as "a cut file".
[[nodiscard]] std::vector<Note> unused_options(const trade::ReadingOptions& options, std::string_view used,
                                               std::string_view what);

}  // namespace selvage::protocol::files
