// Long markers made from copies of a short one, for measuring how the work grows with the number of pieces.
#pragma once

#include <cstddef>

#include "core/marker/marker.h"

namespace selvage::test {

// Multiplies every piece's x by 1 + `slack` and then separates pieces that overlap, so that the layout has that much
// room to lose.
// REQUIRES: the marker is valid.
[[nodiscard]] Marker loosened(const Marker& marker, double slack);

// Places copies of the marker one after another until there are `pieces` pieces, and leaves out the rightmost ones
// beyond that number.  The strip's length is not limited.
[[nodiscard]] Marker tiled(const Marker& marker, std::size_t pieces);

}  // namespace selvage::test
