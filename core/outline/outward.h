// Simplification outwards: a polygon with fewer vertices that holds the given one.  What stays clear of it stays clear
// of the given one too, so models may be built of it; proofs are not.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::outline {

// The polygon grown, by dropping corners that are reflex and by extending the edges beside an edge until they meet, as
// long as no point of its boundary comes farther than `tolerance` (lattice units, to the rounding of a double) from the
// given boundary; least deviations first.
// Laws.  (1) A Polygon.  (2) It holds the given one.  (3) It never has more vertices; the same polygon when nothing can
// go.  (4) Deterministic.
[[nodiscard]] Polygon simplified_outward(const Polygon& polygon, Coord tolerance);

}  // namespace selvage::outline
