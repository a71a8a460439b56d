// How far apart two placed polygons are [Li94 Definition 7.1, for polygons that do not overlap].
#pragma once

#include "core/geometry/overlap.h"

namespace selvage::geometry {

// The distance of p and q, but never more than `reach`; 0 when they touch or overlap.  Made of exact integer products,
// each rounded once: off by a few units in the last place of a double.
[[nodiscard]] double distance_within(const PlacedPolygon& p, const PlacedPolygon& q, double reach);

// The largest whole number of lattice units that p and q are apart, but never more than `reach`.  Exact: they are not
// closer than it, and closer than one more.
[[nodiscard]] Coord whole_distance_within(const PlacedPolygon& p, const PlacedPolygon& q, Coord reach);

}  // namespace selvage::geometry
