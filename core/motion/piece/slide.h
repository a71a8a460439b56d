// Slides a point in a convex cell as far as possible in a direction: the two-variable linear program of a bump, without
// a solver.
#pragma once

#include <span>
#include <vector>

#include "core/model/position_model.h"

namespace selvage::motion::piece {

// x * nx + y * ny >= -slack, with unit (nx, ny); slack >= 0: the origin is inside.
struct CellSide {
  double nx{}, ny{}, slack{};
};

struct Slide {
  RealVec to;                         // the farthest point
  std::vector<std::size_t> blocking;  // the one or two sides that stop it there
};

// From the origin straight towards (ux, uy), then along the sides met, until neither direction along them leads
// farther. In a convex cell this is the optimum.  REQUIRES: (ux, uy) is a unit vector and the cell is bounded in its
// direction.
[[nodiscard]] Slide slide(std::span<const CellSide> cell, double ux, double uy);

}  // namespace selvage::motion::piece
