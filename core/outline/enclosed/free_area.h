// The area of a region without holes, which may overlap each other and reach beyond it, as those of a hide do that were
// drawn one by one.
//
// A vertical line sweeps over the edges.  Between two neighbouring abscissas of corners and crossings, the length of
// its free part is linear in x, so the length half-way times their distance is the area.  It is in floating point: for
// figures and estimates, not for proofs.
// Units: square lattice units.
#pragma once

#include <span>

#include "core/geometry/polygon.h"

namespace selvage::outline::enclosed {

// REQUIRES: simple polygons, as clean_polygon returns them.
// With so many edges above each other, or so many crossings, that it would take seconds, the area of the region alone.
[[nodiscard]] double free_area(const Polygon& region, std::span<const Polygon> holes);

}  // namespace selvage::outline::enclosed
