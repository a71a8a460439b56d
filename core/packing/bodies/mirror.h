// Mirror images: where every layout has a mirror image, or a half turn, that is a layout of the same bodies, one of the
// two need not be searched.
//
// Argument.  Let every body be one piece without rules, in one orientation whose outline is its own image, with no
// fixed pieces and no walls.  (1) Mirrored across the strip, a layout stays one, and no x changes, not even the order
// of pieces of one kind.  So one body, any of them, may be taken to have its middle in the lower half.  (2) Mirrored
// along the strip, a layout up to a ceiling stays one up to it, and the order of the pieces of one kind is reversed.
// The middle one of an odd number of pieces of one kind stays the middle one, so its middle may be taken to lie in the
// left half.  Half turns are like (2).  Where (1) and (2) both hold, so do both restrictions: (2) changes no y.
#pragma once

#include "core/packing/bodies/bodies.h"

namespace selvage::packing::bodies {

// Restricts the problem as far as the argument goes.  REQUIRES: the length is minimised.
void leave_out_mirror_images(const Marker& marker, const Freedom& freedom, Bodies& bodies);

}  // namespace selvage::packing::bodies
