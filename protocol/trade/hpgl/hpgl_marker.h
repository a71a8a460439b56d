// Reads a plot as a marker: every outermost closed outline is a placed piece.
//
// A rectangle around everything else is the frame of the marker: its height is the cloth's width.  Closed lines inside
// a piece become inner lines, open and dashed ones too; a label that begins inside a piece is its name.  A plot does
// not say which of its lines are cut, so a note asks the user to check.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::hpgl {

// The unit is the caller's, else 0.025 mm.
// Errors: kEmptyMarker (nothing closed is drawn), and those of on_lattice.
[[nodiscard]] Result<MarkerFile> read_hpgl_marker(std::string_view text, const ReadingOptions& options);

}  // namespace selvage::protocol::trade::hpgl
