// Perturbation: a small change of a layout, after which the search soon finds places without overlaps again, but other
// ones [LMS03].
#pragma once

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/layout.h"

namespace selvage::nesting::local_search {

// One of these, at random: two pieces change places; two that are near each other do; a few pieces go to random places.
// Smaller pieces that then lie under one of two swapped pieces go where it came from [GVW25].  Does nothing when no
// piece may move.
void perturb(const layout::PieceSet& set, depth::DepthMaps& maps, layout::Dice& dice, layout::Layout& layout);

}  // namespace selvage::nesting::local_search
