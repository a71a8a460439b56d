// A valid layout to begin with: the marker as it is, when it is valid or nearly so, or else its pieces one after
// another along the strip; either of them compacted.
#pragma once

#include <optional>

#include "core/marker/marker.h"
#include "core/scene/run.h"

namespace selvage::packing {

// Nothing when the cloth is too short for the pieces in a row, or fixed pieces overlap.
[[nodiscard]] std::optional<Marker> first_layout(const Marker& start, const scene::Run& run);

}  // namespace selvage::packing
