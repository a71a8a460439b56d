// Set operations on polygons: outlines grown outwards, and what is left of a box when polygons are taken out of it.
// By the Clipper library, seen only behind this header.
//
// Units: lattice units.  Vertices of the input are kept; where two edges cross, the corner is rounded to the lattice,
// so a boundary may be a unit or two off: good for finding and measuring regions, never for a proof.
// Coordinates stay below 2^42 in size (the library's limit is 2^62).
#pragma once

#include <span>
#include <vector>

#include "core/outline/region.h"

namespace selvage::outline {

// The polygon and all points within `distance` of it, in one piece or, when it all but closes on itself, with holes;
// corners are mitred, so that they reach up to twice as far.  As rings: outlines counter-clockwise, holes clockwise.
[[nodiscard]] std::vector<Polygon> grown(std::span<const Vec> polygon, Coord distance);

// The connected regions of the box that no ring of `taken` winds around, sorted.  What hangs together in single points
// only may come as one region or as two.
[[nodiscard]] std::vector<Region> left_over(const Box& box, const std::vector<Polygon>& taken);

}  // namespace selvage::outline
