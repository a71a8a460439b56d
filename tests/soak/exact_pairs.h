// Do two polygons overlap, or come closer than a distance?  An answer for the judge of the soak, in exact integers,
// that shares neither code nor method with core/geometry/overlap.h.
//
// Coordinates are lattice units below 2^41; both polygons are simple and counter-clockwise, with no idle vertex.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::test {

// True when the interiors meet.
// Method: a proper crossing of two edges settles it.  Without one, boundaries meet in vertices of either polygon only;
// between two such points a stretch of one boundary lies wholly inside the other polygon, wholly outside, or along its
// boundary, which its midpoint tells.  When no stretch lies inside, the boundary of what both hold would be a part of
// both boundaries: then they are the same polygon, or hold nothing in common.
[[nodiscard]] bool interiors_share(const Polygon& p, const Polygon& q);

// True when some two points of p and q are less than `distance` > 0 apart.
[[nodiscard]] bool nearer_than(const Polygon& p, const Polygon& q, Coord distance);

// True when two edges that are not neighbours share a point.
[[nodiscard]] bool touches_itself(const Polygon& p);

}  // namespace selvage::test
