// Whether two placed polygons overlap, or come closer than a distance.  Exact: this is what every answer is proved
// with.
//
// Two polygons overlap when their interiors meet; touching along points or edges is not overlapping.
#pragma once

#include <optional>
#include <span>

#include "core/geometry/lattice.h"
#include "core/geometry/polygon.h"
#include "core/geometry/real_vec.h"

namespace selvage::geometry {

// A polygon with its box, moved by `at`.
struct PlacedPolygon {
  std::span<const Vec> vertices;
  Box box;  // of the vertices, before they are moved
  Vec at;
  [[nodiscard]] Box placed_box() const { return box.moved(at); }
};

// True when the interiors meet.
// Method: without a proper crossing of two edges, either the boundaries share points, and then the interiors meet
// exactly if their cones at some shared point do; or they share none, and then one polygon holds the other or they are
// apart.
[[nodiscard]] bool overlap(const PlacedPolygon& p, const PlacedPolygon& q);

// True when some two points of p and q are less than `distance` > 0 apart.
[[nodiscard]] bool closer_than(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance);

// A point inside both, rounded to doubles, when they overlap; for reports only.
[[nodiscard]] std::optional<RealVec> common_point(const PlacedPolygon& p, const PlacedPolygon& q);

// The midpoint of a shortest line between the two boundaries, rounded; for reports only.
[[nodiscard]] RealVec nearest_point(const PlacedPolygon& p, const PlacedPolygon& q);

}  // namespace selvage::geometry
