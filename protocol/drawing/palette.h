// Colours for the shapes of a marker: muted ones, with the same hue for mirror images and different hues for
// neighbours.
#pragma once

#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::protocol::drawing {

// One colour per shape, as "#rrggbb".
[[nodiscard]] std::vector<std::string> shape_colours(const Marker& marker, const std::vector<Polygon>& placed);

}  // namespace selvage::protocol::drawing
