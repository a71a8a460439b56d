// The laws that every Minkowski sum must satisfy, tested against CGAL's exact sum and by brute force.
#pragma once

#include <string>

#include "core/minkowski/sum.h"
#include "tests/support/exact.h"

namespace selvage::test {

// The two summands.  The second may be the image of the polygon that the edges' sources refer to.
struct Summands {
  Polygon first;
  Polygon second;      // the polygon that sources refer to
  Symmetry of_second;  // the symmetry applied to it before the addition
  [[nodiscard]] Polygon second_image() const { return transformed(second, of_second); }
};

// Returns an empty string when all laws hold, and otherwise the broken law and the summands.
// (1) The union of the rings differs from the exact sum by no more than a unit along its boundary.
// (2) No edge lies inside another ring by more than rounding, except for short ends at sharp corners.  (Slots of zero
// width and holes that shrink to a point are shown.)
// (3) The edges cover the exact boundary, and their total length is its length, apart from edges that run along each
// other.
// (4) No part of an exact line occurs twice.
// (5) The end points of every edge lie within one and a half units of its exact line, and in its direction.
// (6) An edge's line is the sum of the vertex and the edge that its source refers to.
// (7) The sum is on the left of every edge and not on its right.
[[nodiscard]] std::string broken_law(const Summands& summands, const minkowski::MinkowskiSum& sum);

// Tests the laws of single edges, (5) and (6), which need no exact sum.
[[nodiscard]] std::string broken_source(const Summands& summands, const minkowski::MinkowskiSum& sum);

}  // namespace selvage::test
