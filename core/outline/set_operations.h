// Set operations on polygons: outlines grown outwards, on all sides alike or by lengths of their own, and the regions
// of a box that polygons do not cover.  The Clipper library does the work; it is used only behind this header.
//
// Units: lattice units.  Input vertices are kept.  Where two edges cross, the new corner is rounded to the lattice, so
// a boundary can be one or two units off: accurate enough to find and measure regions, but never used for proofs.
// Coordinates stay below 2^42 in size (the library's limit is 2^62).
#pragma once

#include <span>
#include <vector>

#include "core/outline/region.h"

namespace selvage::outline {

// The polygon and all points within `distance` of it.  Corners are mitred, so they extend up to twice the distance.
// The result is a list of rings: outlines counter-clockwise, and holes clockwise where the polygon nearly closes on
// itself.
[[nodiscard]] std::vector<Polygon> grown(std::span<const Vec> polygon, Coord distance);

// The outer boundary of all points of the polygon, displaced by all vectors of the box: its Minkowski sum with the box,
// holes filled; vertices may lie in the middle of its straight edges.  REQUIRES: the box contains (0, 0); the polygon
// is counter-clockwise.
[[nodiscard]] Polygon widened(std::span<const Vec> polygon, const Box& by);

// The largest outer boundary of what a ring that may cross itself encloses (non-zero winding), counter-clockwise and
// with holes filled.  Empty if the ring encloses nothing.
[[nodiscard]] Polygon outer_boundary(std::span<const Vec> ring);

// The connected regions of the box outside all rings of `taken` (non-zero winding), sorted.  Parts that are connected
// only at single points may be returned as one region or as two.
[[nodiscard]] std::vector<Region> left_over(const Box& box, const std::vector<Polygon>& taken);

}  // namespace selvage::outline
