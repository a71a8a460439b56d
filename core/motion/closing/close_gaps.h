// Closing gaps, before the first round of compaction.
//
// A round's program has rows for near pairs only.  Suppose that a gap separates two groups of pieces, as when one
// marker lies behind another.  No row then stops the right group: the solution moves it on top of the left one, and
// hundreds of pairs that are far apart now have to enter the program, whose factor becomes dense.  So the right group,
// called a body, first moves to the left as a whole.  A lower bound on the free distance is enough (slabs.h), because
// the rounds close what is left of the gap.
#pragma once

#include <cstddef>

#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::closing {

// Pieces belong to one body when they are tied, or within the distance `near` of each other beyond their spacing,
// directly or through others.  A body is held when one of its pieces is that near to the strip's left end, or fixed
// along the strip.  Moves every other body straight to the left, one after another, if these have at least `many`
// pieces in all.  Returns whether something moved.  The pieces stay valid.
// When cancelled, it stops between two bodies.
// REQUIRES: the scene's pieces are valid.
bool close_gaps(scene::Scene& scene, Coord near, std::size_t many, const scene::Run& run);

}  // namespace selvage::motion::closing
