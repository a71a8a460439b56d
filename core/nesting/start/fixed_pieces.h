// The pieces that a nesting search finds on the cloth and leaves there.
#pragma once

#include <vector>

#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::start {

// The marker with all pieces off the cloth but the fixed ones; they are the first unplaced ones.
[[nodiscard]] Marker with_pieces_taken_off(const Marker& given, const layout::PieceSet& set);

// By placed piece, whether it stays where it is at first: all pieces do when they lie validly, otherwise the fixed
// ones.
[[nodiscard]] std::vector<bool> kept_where_valid(const Marker& start, const layout::PieceSet& set);

}  // namespace selvage::nesting::start
