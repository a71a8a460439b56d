// Narrow parts of an outline: where two edges that face away from each other run closer together than a given width.
// With an overlap allowance of that width another piece may lie over all of the part, because a translation no
// longer than the allowance moves it out across the part.
// Units: lattice units.
#pragma once

#include <optional>

#include "core/geometry/polygon.h"

namespace selvage::outline {

// A vertex of a part that is narrower than `width`; nothing when there is none.  The corner between two long edges is
// not a narrow part, however acute it is: edges count where all of the stretch along which they run beside each other
// is narrow.  REQUIRES: the polygon is counter-clockwise.
[[nodiscard]] std::optional<Vec> narrow_part(const Polygon& polygon, Coord width);

}  // namespace selvage::outline
