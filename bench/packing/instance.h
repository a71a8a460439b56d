// Strip packing instances in the JSON of jagua-rs (github.com/JeroenGar/jagua-rs), without a solution.
#pragma once

#include <string>

#include "core/marker/marker.h"

namespace selvage::bench {

// The instance's pieces, all at the origin, in their first allowed orientation.  Without `turns` they keep it.
// Ends the program with a message when the file cannot be read.
[[nodiscard]] Marker read_instance(const std::string& path, bool turns);

}  // namespace selvage::bench
