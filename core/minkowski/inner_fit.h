// The inner fit of a piece in the strip: where its position may be so that it stays inside [Li94 3.3.2, 4.1.3].
#pragma once

#include "core/geometry/lattice.h"

namespace selvage {

// Positions of a piece with box `piece` that keep it within [0, length] x [0, width]; empty (high < low) when it does
// not fit.
[[nodiscard]] constexpr Box inner_fit(const Box& piece, Coord length, Coord width) {
  return {{-piece.low.x, -piece.low.y}, {length - piece.high.x, width - piece.high.y}};
}

}  // namespace selvage
