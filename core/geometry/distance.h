// The distance between two placed polygons [Li94 Definition 7.1, restricted to polygons that do not overlap].
// Units: lattice units.
#pragma once

#include "core/geometry/overlap.h"

namespace selvage::geometry {

// The distance between p and q, capped at `reach`; 0 when they touch or overlap.  It is computed from exact integer
// products, each rounded once, so its error is a few units in the last place of a double.
[[nodiscard]] double distance_within(const PlacedPolygon& p, const PlacedPolygon& q, double reach);

// The distance between p and q rounded down to whole lattice units, capped at `reach`.  Exact: the polygons are not
// closer than the result and, below the cap, they are closer than the result plus one.
[[nodiscard]] Coord whole_distance_within(const PlacedPolygon& p, const PlacedPolygon& q, Coord reach);

}  // namespace selvage::geometry
