// Exact triangulation of a simple polygon by ear clipping.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline::decomposition {

// Three vertex indices in counter-clockwise order.
using Triangle = std::array<std::uint32_t, 3>;
// The n - 2 triangles of a polygon with n vertices; their union is the polygon and none has zero area.
[[nodiscard]] std::vector<Triangle> triangulate(const Polygon& polygon);

}  // namespace selvage::outline::decomposition
