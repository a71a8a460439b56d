// The Minkowski sum of two convex polygons by merging their edges [Li94 3.4.1]; exact.
#pragma once

#include "core/minkowski/star_sum.h"

namespace selvage {

// The same as star_sum.  REQUIRES: both convex.
[[nodiscard]] StarSum convex_sum(const StarPart& first, const StarPart& second);

}  // namespace selvage
