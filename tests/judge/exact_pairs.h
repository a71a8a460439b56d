// Exact tests of whether two polygons overlap, or are closer than a given distance, for the judge of the soak test.
// They share neither code nor method with core/geometry/overlap.h.
//
// Units: lattice units below 2^41.
// REQUIRES (all functions): both polygons are simple and counter-clockwise, without redundant vertices.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::test {

// True when the interiors intersect.
// Method: a proper crossing of two edges proves an intersection.  Without one, the boundaries meet only at vertices of
// either polygon, and between two such points a part of one boundary lies wholly inside the other polygon, wholly
// outside, or along its boundary; the midpoint decides which.  If no part lies inside, the boundary of the intersection
// would consist of common parts of both boundaries, so the polygons are either identical or have disjoint interiors.
[[nodiscard]] bool interiors_share(const Polygon& p, const Polygon& q);

// True when p and q are less than `distance` apart.  REQUIRES: distance > 0.
[[nodiscard]] bool nearer_than(const Polygon& p, const Polygon& q, Coord distance);

// True when moving q by a vector no longer than `distance` leaves no interior point in common with p.
// REQUIRES: distance > 0.  Method: with the nearest such translation a vertex of one touches an edge of the
// other, or two vertices two edges.  For every vertex and edge, and for every two of them, vectors of whole
// units and of sixteenths about the nearest such translation are tried, each with interiors_share, and last
// those that separate the two boxes.  The answer true is certain; a translation between such points may be
// missed.
[[nodiscard]] bool separable_within(const Polygon& p, const Polygon& q, Coord distance);

// True when two edges that are not neighbours share a point.
[[nodiscard]] bool touches_itself(const Polygon& p);

}  // namespace selvage::test
