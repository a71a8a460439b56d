// Outward simplification: a polygon with fewer vertices that contains the given one.  Whatever does not overlap the
// simplified polygon does not overlap the given one either, so models may use simplified polygons.  Validity proofs
// never do.
// Units: lattice units.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::outline {

// Enlarges the polygon by dropping reflex corners, and by replacing an edge with the intersection of its two
// neighbouring edges, extended.  No point of the new boundary is farther than `tolerance` from the given boundary (to
// the rounding of a double).  Changes with the smallest deviation are made first.
// Laws.
// (1) The result is a Polygon.
// (2) It contains the given polygon.
// (3) It has at most as many vertices; when no change is possible, it is the given polygon.
// (4) Deterministic.
[[nodiscard]] Polygon simplified_outward(const Polygon& polygon, Coord tolerance);

}  // namespace selvage::outline
