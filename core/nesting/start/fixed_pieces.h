// The pieces that a nesting search finds on the cloth and leaves there.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::start {

// The marker with all pieces off the cloth but the fixed ones; they are the first unplaced ones.
[[nodiscard]] Marker with_pieces_taken_off(const Marker& given, const layout::PieceSet& set);

// Pieces that no search may move must lie validly.  `fixed`: at least for every placed piece, whether it is one of
// them.
// Errors: kMarkerOverlaps and kOutsideStrip when they do not; `field` is a JSON pointer into the marker.
[[nodiscard]] std::optional<Error> defect_of_fixed(const Marker& start, const std::vector<bool>& fixed);

// By placed piece, whether it stays where it is at first: all pieces do when they lie validly, otherwise the fixed
// ones.
[[nodiscard]] std::vector<bool> kept_where_valid(const Marker& start, const layout::PieceSet& set);

}  // namespace selvage::nesting::start
