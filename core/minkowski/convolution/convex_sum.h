// The exact Minkowski sum of two convex polygons, by merging their edges [Li94 3.4.1].
#pragma once

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::convolution {

// Equivalent to star_sum.  REQUIRES: both parts are convex.
[[nodiscard]] StarSum convex_sum(const outline::StarPart& first, const outline::StarPart& second);

}  // namespace selvage::minkowski::convolution
