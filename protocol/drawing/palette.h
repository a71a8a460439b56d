// Colours for the shapes of a marker: calm ones, the same for mirror images up to a shade, different for
// neighbours.
#pragma once

#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::protocol::drawing {

// One per shape, as "#rrggbb".
[[nodiscard]] std::vector<std::string> shape_colours(const Marker& marker, const std::vector<Polygon>& placed);

}  // namespace selvage::protocol::drawing
