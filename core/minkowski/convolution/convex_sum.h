// The Minkowski sum of two convex polygons by merging their edges [Li94 3.4.1]; exact.
#pragma once

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::convolution {

// The same as star_sum.  REQUIRES: both convex.
[[nodiscard]] StarSum convex_sum(const outline::StarPart& first, const outline::StarPart& second);

}  // namespace selvage::minkowski::convolution
