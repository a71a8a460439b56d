// A region in which pieces must lie: a box, or a simple polygon.
//
// What a polygon leaves of its bounding box are its walls: one simple polygon for every part of the border that leaves
// the box's sides and comes back.  A piece in the box lies in the polygon exactly when it overlaps no wall.  All
// corners of walls are corners of the polygon or of the box, so nothing is rounded.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline::enclosed {

struct Container {
  // A wall has corners of the polygon, and at most the four of the box.
  static constexpr std::size_t kMostCorners = geometry::kMaxVertices - 4;

  Container(const Box& whole) : box{whole} {}  // NOLINT(*-explicit-*): a box is a container
  // REQUIRES: as clean_polygon returns them, with at most kMostCorners corners.
  explicit Container(const Polygon& polygon);

  Box box;
  std::vector<Polygon> walls;
};

// The container within another box.
[[nodiscard]] Container within(Container container, const Box& box);

}  // namespace selvage::outline::enclosed
