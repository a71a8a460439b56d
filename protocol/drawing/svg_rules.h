// Cloth's rules in a drawing: selvedges, the fold, the ends of bands, the cloth on which each shade lies, and zones.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// Empty when neither the strip nor a piece has rules.
[[nodiscard]] std::string rules(const Marker& marker, const View& view);
// The parts of zones that lie on the row's cloth, which they may extend beyond.  They are drawn over pieces: what
// covers one is seen.
[[nodiscard]] std::string zones(const Marker& marker, const View& view);

}  // namespace selvage::protocol::drawing
