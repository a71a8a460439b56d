// A marker that has all pieces of a search as placed ones, while only some of them lie on the cloth.
#pragma once

#include <vector>

#include "core/marker/marker.h"

namespace selvage::nesting::filling {

// The marker with the pieces that lie; the others become unplaced, at position 0.  Pieces keep their order.
// REQUIRES: `lies` has an entry for each of the marker's placed pieces.
[[nodiscard]] Marker with_lying_pieces(const Marker& all, const std::vector<bool>& lies);

// Which of the marker's pieces end before x = `last`.
[[nodiscard]] std::vector<bool> pieces_before(const Marker& marker, Coord last);

}  // namespace selvage::nesting::filling
