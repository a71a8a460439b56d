// Cloth's rules in a drawing: selvedges, the fold, the ends of bands, and the cloth on which each shade lies.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// Empty when neither the strip nor a piece has rules.
[[nodiscard]] std::string rules(const Marker& marker, const View& view);

}  // namespace selvage::protocol::drawing
