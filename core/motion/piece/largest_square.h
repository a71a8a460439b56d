// The largest axis-parallel square in a convex cell: the program of three variables behind relaxation [Li94 6.1.1].
// No linear program is built: Seidel's incremental method [Sei91] puts the sides in one by one, nearest first, and
// looks for a new optimum on a side, with a variable less, only when the present one breaks it.
#pragma once

#include <span>

#include "core/motion/piece/slide.h"

namespace selvage::motion::piece {

struct Square {
  RealVec centre;  // from the origin
  double half{};   // of its side; negative when the cell is empty: by so much the sides would have to give way
};

// Here the sides' slack may be negative: the origin need not be inside.  Only centres with |x|, |y| <= reach are looked
// at.  REQUIRES: reach > 0.
[[nodiscard]] Square largest_square(std::span<const CellSide> cell, double reach);

}  // namespace selvage::motion::piece
