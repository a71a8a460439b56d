// Valid layouts to begin with: the marker as it is, or else its pieces one after another along the strip.
#pragma once

#include <optional>

#include "core/marker/marker.h"
#include "core/scene/run.h"

namespace selvage::packing {

// The first of the two that is valid without being changed; nothing when neither is.
[[nodiscard]] std::optional<Marker> rough_layout(const Marker& start);

// The marker, also when it is only nearly valid, or else the row; compacted.  Nothing when the cloth is too short for
// the pieces in a row, or fixed pieces overlap.
[[nodiscard]] std::optional<Marker> first_layout(const Marker& start, const scene::Run& run);

}  // namespace selvage::packing
