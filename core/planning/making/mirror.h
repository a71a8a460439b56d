// Whether two shapes are mirror images of each other, as the left and the right piece of a pair are.
#pragma once

#include "core/geometry/polygon.h"

namespace selvage::planning::making {

// Whether the mirror image of `a` about the grain, moved so that the boxes coincide and turned by 0 or 180 degrees, is
// `b`: no vertex of either lies farther than `slack` from the outline of the other.  Floating point; lattice units.
[[nodiscard]] bool are_mirror_images(const Polygon& a, const Polygon& b, double slack);

}  // namespace selvage::planning::making
