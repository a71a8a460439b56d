// A connected region of the plane with holes: its area, point location, and a point inside it.
#pragma once

#include <compare>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline {

// Every ring starts at its smallest vertex (by x, then y) and runs with the interior to its left.  Rings may touch
// themselves or each other at single points.  Units: lattice units.
struct Region {
  Polygon outline;             // counter-clockwise
  std::vector<Polygon> holes;  // clockwise, sorted
  friend auto operator<=>(const Region&, const Region&) = default;
};

// The area inside the outline and outside the holes, in square lattice units; exact except for one rounding.
[[nodiscard]] double area_of(const Region& region);

// Whether the point lies inside, outside or on the boundary.  Exact.
[[nodiscard]] geometry::Location locate(Vec point, const Region& region);

// A point well inside the region: of the midpoints of several horizontal chords, the one farthest from the boundary.  A
// vertex when the region is so thin that no such midpoint is a lattice point inside it.
[[nodiscard]] Vec point_inside(const Region& region);

}  // namespace selvage::outline
