// Exact tests of whether two placed polygons overlap, or are closer than a given distance.  The validity of every
// result is proved with these tests.
//
// Two polygons overlap when their interiors intersect; touching at points or along edges is not overlapping.
// Units: lattice units.
#pragma once

#include <optional>
#include <span>

#include "core/geometry/lattice.h"
#include "core/geometry/polygon.h"
#include "core/geometry/real_plane.h"

namespace selvage::geometry {

// A polygon with its bounding box, translated by `at`.
struct PlacedPolygon {
  std::span<const Vec> vertices;
  Box box;  // of the vertices before translation
  Vec at;
  [[nodiscard]] Box placed_box() const { return box.moved(at); }
};

// True when the interiors intersect.
// Method: two edges that cross properly prove an overlap.  Otherwise, if the boundaries share points, the interiors
// intersect exactly when the interior cones at some shared point do.  If the boundaries share no point, the polygons
// overlap exactly when one contains the other.
[[nodiscard]] bool overlap(const PlacedPolygon& p, const PlacedPolygon& q);

// True when p and q are less than `distance` apart.  REQUIRES: distance > 0.
[[nodiscard]] bool closer_than(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance);

[[nodiscard]] std::optional<RealVec> common_point(const PlacedPolygon& p, const PlacedPolygon& q);

// The midpoint of a shortest segment between the two boundaries, rounded to doubles; for reports only.
[[nodiscard]] RealVec nearest_point(const PlacedPolygon& p, const PlacedPolygon& q);

}  // namespace selvage::geometry
