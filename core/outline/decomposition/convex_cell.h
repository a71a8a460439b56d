// A convex polygon that is cut by lines, in doubles: the cell of an intersection of half-planes.
#pragma once

#include <vector>

#include "core/geometry/real_plane.h"

namespace selvage::outline::decomposition {

// Counter-clockwise; empty when nothing is left.
using ConvexCell = std::vector<RealVec>;

// The box, in coordinates relative to `centre`, which keeps rounding small.
[[nodiscard]] ConvexCell cell_of(const Box& box, Vec centre);
// Keeps what lies to the left of the line through `at` with direction `along`.  `scratch` is overwritten.
void clip(ConvexCell& cell, RealVec at, RealVec along, ConvexCell& scratch);
// REQUIRES: the cell is not empty.
[[nodiscard]] RealVec centroid(const ConvexCell& cell);

}  // namespace selvage::outline::decomposition
