// Long markers out of short ones: copies of a marker one after another, for measuring how work grows.
#pragma once

#include <cstddef>

#include "core/marker/marker.h"

namespace selvage::test {

// The marker with every piece's x stretched by 1 + `slack`, and what overlaps then separated: a layout that has so much
// room to lose.  REQUIRES: marker is valid.
[[nodiscard]] Marker loosened(const Marker& marker, double slack);

// Copies of the marker side by side until there are `pieces` of them, those farthest to the right left out.  The
// strip has no end.
[[nodiscard]] Marker tiled(const Marker& marker, std::size_t pieces);

}  // namespace selvage::test
