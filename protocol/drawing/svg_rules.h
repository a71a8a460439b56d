// Draws cloth's rules: selvedges, the fold, the ends of bands, the extent of each shade, and zones.
#pragma once

#include <string>

#include "core/marker/marker.h"
#include "protocol/drawing/svg_view.h"

namespace selvage::protocol::drawing {

// Empty when neither the strip nor a piece has rules.
[[nodiscard]] std::string rules(const Marker& marker, const View& view);
// The parts of zones that lie on the cloth of the row; zones may extend beyond it.  They are drawn over the pieces, so
// that a piece on a zone is noticed.
[[nodiscard]] std::string zones(const Marker& marker, const View& view);

}  // namespace selvage::protocol::drawing
