// Outlines that cross or touch themselves in a small loop, as seam allowances do at corners and rounding does at
// repeated vertices.  Units: millimetres.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::trade::outlines {

// Replaces an outline that crosses or touches itself by the outer boundary of what it encloses, if the area changes by
// at most 100 mm2 and one per cent.  Returns what to note, with the piece's name; none if the outline is left as it is.
std::optional<std::string> uncross(std::vector<document::Spot>& outline, const std::string& piece);

}  // namespace selvage::protocol::trade::outlines
