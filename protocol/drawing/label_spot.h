// Where a label fits best inside an outline.
#pragma once

#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::protocol::drawing {

struct LabelSpot {
  double x{}, y{};       // the label's middle
  double half_height{};  // of the largest label that fits there; in the outline's units
  bool upright{};        // the text runs along y, since the outline is narrow
};

// `aspect`: the label's width over its height.  `enough`: half the height of the largest label wanted; among
// the spots with that much room, one near the middle of the outline is taken.  The label lies in none of the holes.
// REQUIRES: Polygons.
[[nodiscard]] LabelSpot find_label_spot(const Polygon& outline, double aspect, double enough,
                                        const std::vector<Polygon>& holes = {});

}  // namespace selvage::protocol::drawing
