// The inner fit of a piece in the strip: where its position may be so that it stays inside [Li94 3.3.2, 4.1.3].
#pragma once

#include "core/geometry/lattice.h"

namespace selvage::minkowski {

// Positions of a piece with box `piece` that keep it within `room`; empty (high < low) when it does not fit.
[[nodiscard]] constexpr Box inner_fit(const Box& piece, const Box& room) {
  return {room.low - piece.low, room.high - piece.high};
}

}  // namespace selvage::minkowski
