// What must hold of every Minkowski sum, judged by CGAL's exact one and by brute force.
#pragma once

#include <string>

#include "core/minkowski/sum.h"
#include "tests/support/exact.h"

namespace selvage::test {

// The two polygons that were added up; the second may be the image of the polygon that edge sources name.
struct Summands {
  Polygon first;
  Polygon second;      // as sources name it
  Symmetry of_second;  // what was done to it before it was added
  [[nodiscard]] Polygon second_image() const { return transformed(second, of_second); }
};

// Nothing when all laws hold, else what is broken, with the summands.
//  (1) The rings' union differs from the exact sum by no more than a unit along its boundary.
//  (2) No edge lies inside another ring by more than rounding, but for stubs at sharp corners.  (Slots
//  without any width and
//      holes that close to a point do show.)
//  (3) The edges cover the exact boundary; their length is its length, but for what another edge runs beside.
//  (4) No stretch of an exact line is there twice.
//  (5) Every edge's ends lie within a unit and a half of its exact line, in its direction.
//  (6) An edge's line is made by the vertex and the edge that its source names.
//  (7) The sum is on the left of every edge and not on its right.
[[nodiscard]] std::string broken_law(const Summands& summands, const minkowski::MinkowskiSum& sum);

// The laws of single edges, which need no exact sum: (5) and (6).
[[nodiscard]] std::string broken_source(const Summands& summands, const minkowski::MinkowskiSum& sum);

}  // namespace selvage::test
