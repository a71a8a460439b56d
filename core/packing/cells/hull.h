// The convex hull of the cells of an arc, as half-planes: the strongest rows that the arc gives to a linear relaxation.
// Units: lattice units.
#pragma once

#include <vector>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::cells {

// Appends the half-plane, unless its border lies along an axis.
void append_side(const HalfPlane& plane, std::vector<HalfPlane>& planes);

// Appends the half-planes of the points' convex hull, but for those along the axes, which the box of a pair has.  Each
// is moved outwards by kRounding, so that it contains all points in spite of rounding.  Sorts the points.
void append_hull(std::vector<RealVec>& points, std::vector<HalfPlane>& planes);

}  // namespace selvage::packing::cells
