// A marker as a plot: HP-GL/2 of the subset ASTM D6959.
//
// Units of 0.025 mm, absolute and positive, strokes only, in one block.  Drawn are the frame of the marker, outlines,
// notches, drill holes, inner lines, and each piece's label; above the frame stand length, width and utilisation.
#pragma once

#include <string>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

[[nodiscard]] std::string hpgl_file(const Sheet& sheet);

}  // namespace selvage::protocol::plots
