// The outline of every placed piece, for cutters, plotters and independent checks.  This format is only written.
//
// {"strip_height": H, "strip_length": L, "pieces": [{"id", "outline": [[x, y], ...], "overlap"}]}; strip_height is the
// strip's width across, strip_length the marker's length, outlines counter-clockwise, every number the exact
// decimal of its lattice coordinate.  `overlap`: the overlap allowance of the piece when it has one and no spacing or
// buffer overrides it; two pieces may overlap by the smaller of their two.
#pragma once

#include "core/marker/marker.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::formats {

[[nodiscard]] Json outlines_document(const Marker& marker);

}  // namespace selvage::protocol::formats
