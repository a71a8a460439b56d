// The largest axis-parallel square in a convex cell: the program of three variables behind relaxation [Li94 6.1.1].
// No solver is needed: Seidel's incremental method [Sei91] adds the sides one by one, nearest first, and only when the
// present optimum violates a side does it look for a new one on that side, with one variable less.
#pragma once

#include <span>

#include "core/motion/piece/slide.h"

namespace selvage::motion::piece {

struct Square {
  RealVec centre;  // from the origin
  double half{};   // of its side; negative when the cell is empty: the sides would have to move outwards by as much
};

// Here the slack of a side may be negative: the origin need not be inside.  Only centres with |x|, |y| <= reach are
// considered.  REQUIRES: reach > 0.
[[nodiscard]] Square largest_square(std::span<const CellSide> cell, double reach);

}  // namespace selvage::motion::piece
