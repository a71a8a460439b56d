// The inner fit of a piece in the strip: the positions at which the piece lies inside the strip [Li94 3.3.2, 4.1.3].
#pragma once

#include "core/geometry/lattice.h"

namespace selvage::minkowski {

// The positions at which a piece with bounding box `piece` lies within `room`; empty (high < low) when it does not fit.
[[nodiscard]] constexpr Box inner_fit(const Box& piece, const Box& room) {
  return {room.low - piece.low, room.high - piece.high};
}

}  // namespace selvage::minkowski
