// What nesting does where the cloth ends: pieces that reach beyond the end come off the cloth, and those of them that
// still fit somewhere are put there.
#pragma once

#include <cstddef>

#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"
#include "core/scene/run.h"

namespace selvage::nesting {

// The number of pieces that are left over: they become unplaced.  Pieces keep their order; fixed ones stay.  When
// cancelled, no more pieces are put back.
// REQUIRES: the set is that of the marker, all of whose pieces are placed; they are valid but for the end of the cloth,
// which fixed pieces do not reach beyond.
[[nodiscard]] std::size_t end_with_cloth(Marker& marker, const layout::PieceSet& set, const scene::Run& run);

}  // namespace selvage::nesting
