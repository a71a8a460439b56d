// A connected part of the plane between an outline and holes, and what can be asked of it.
#pragma once

#include <compare>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline {

// Rings start at their smallest vertex (by x, then y), run with the inside to their left, and may touch themselves or
// each other in single points.  Lattice units.
struct Region {
  Polygon outline;             // counter-clockwise
  std::vector<Polygon> holes;  // clockwise, sorted
  friend auto operator<=>(const Region&, const Region&) = default;
};

// What the outline holds less the holes; square lattice units, exact but for one rounding.
[[nodiscard]] double area_of(const Region& region);

// Where a point lies.  Exact.
[[nodiscard]] geometry::Location locate(Vec point, const Region& region);

// A point well inside: of some horizontal chords' midpoints the one farthest from the boundary.  A vertex of a region
// so thin that it holds no lattice point there.
[[nodiscard]] Vec point_inside(const Region& region);

}  // namespace selvage::outline
