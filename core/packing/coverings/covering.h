// Convex coverings of the outside of a star-shaped Minkowski sum: the convex sets among which an exact search chooses
// one for each pair of pieces [Li94 8.2, Definition 8.1].  There are three, which differ in how many sets they have and
// whether these overlap; docs/measurements/searches/packing.md compares them.
//
// - Wedges: beyond one edge, between the rays from the centre through its ends.  As many as there are edges; disjoint.
//   The search of core/packing/branching uses them.
// - The walk of the thesis [Li94 8.2.1]: from an edge along the boundary both ways, extending edges past convex
//   corners, until the set is closed; then from the next edge that is in no set yet.  Few sets, which overlap.
// - Vertical slices: the plane is cut at the x of every corner [LO24].  Disjoint, and bounded by two vertical lines
//   and by at most two edges.
//
// Laws.  (1) Every point outside of the sum is in some set.  (2) No set reaches into the sum by more than rounding, two
// units.  (3) Disjoint sets share no more than their borders, up to the same rounding.  All as in wedge_ring.h, which
// moves lines outwards: what is concluded from the sets holds for all valid layouts.
// Units: lattice units.
#pragma once

#include <vector>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::coverings {

using cells::HalfPlane;
using cells::WedgeRing;

// The points in all of its half-planes.
using ConvexSet = std::vector<HalfPlane>;

[[nodiscard]] std::vector<ConvexSet> wedges(const WedgeRing& ring);
[[nodiscard]] std::vector<ConvexSet> walk(const WedgeRing& ring);
[[nodiscard]] std::vector<ConvexSet> slices(const WedgeRing& ring);

}  // namespace selvage::packing::coverings
