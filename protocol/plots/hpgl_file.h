// A marker as a plot: HP-GL/2 of the subset ASTM D6959.
//
// Units of 0.025 mm, absolute and positive, strokes only, in one block.  It draws the frame of the marker, outlines,
// notches, drill holes, inner lines and each piece's label; length, width and utilisation are above the frame.
#pragma once

#include <string>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

[[nodiscard]] std::string hpgl_file(const Sheet& sheet);

}  // namespace selvage::protocol::plots
