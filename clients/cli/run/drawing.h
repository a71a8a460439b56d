// The picture of a marker after a command, with what was asked to be drawn over it.
#pragma once

#include "protocol/drawing/svg.h"

namespace selvage::cli::run {

struct DrawingWish {
  bool arrows{};  // how the pieces went, and the forces on them
  bool chain{};   // what holds the length
};

// `end` is what came of `start` by a call with these parameters.  A marker that is not valid has no chain.
[[nodiscard]] protocol::drawing::SvgOptions drawing_of(const MarkerFile& end, const Marker& start, const Json& params,
                                                       const DrawingWish& wish);

}  // namespace selvage::cli::run
