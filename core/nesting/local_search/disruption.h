// Disruption: two large pieces change places, so that the search leaves a part of the space that it has exhausted
// [GVW25].  Smaller pieces that then lie under one of them go where it came from.
#pragma once

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/layout.h"

namespace selvage::nesting::local_search {

// The largest pieces that together have `large_part` of the area of all convex hulls count as large.  Does nothing when
// fewer than two pieces may move.
void swap_large_pieces(const layout::PieceSet& set, depth::DepthMaps& maps, double large_part, layout::Dice& dice,
                       layout::Layout& layout);

}  // namespace selvage::nesting::local_search
