// Closing gaps, before the first round of compaction.
//
// A round has rows for near pairs only.  Pieces that lie together, with nothing near on their left, such as the second
// of two markers that lie one behind the other, would all move on top of the pieces before them: hundreds of far pairs
// would collide and enter the program, whose factor becomes dense.  So such a body of pieces is first moved to the left
// as a whole.  The way is found on slabs along the strip, in each of which a piece counts as a box, so a little of the
// gap may stay: that is for the rounds.
#pragma once

#include <cstddef>

#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::closing {

// Bodies are the pieces that are connected by pairs that lie within `near` of each other, beyond their spacing, or by
// ties; a body is held when one of its pieces is that near to the strip's left end, or fixed along it.  Moves every
// body that is not held straight to the left, one after another, provided that they have `many` pieces or more
// together. True when something moved.  The pieces stay valid.  When cancelled, it stops between two bodies. REQUIRES:
// the scene's pieces are valid.
bool close_gaps(scene::Scene& scene, Coord near, std::size_t many, const scene::Run& run);

}  // namespace selvage::motion::closing
