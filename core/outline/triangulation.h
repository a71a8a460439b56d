// Triangulation of a simple polygon by cutting ears; exact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline {

// Vertex indices, counter-clockwise.
using Triangle = std::array<std::uint32_t, 3>;
// n - 2 triangles whose union is the polygon; none has zero area.
[[nodiscard]] std::vector<Triangle> triangulate(const Polygon& polygon);

}  // namespace selvage::outline
