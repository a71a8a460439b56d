// DXF without pattern pieces, such as a drawing program writes: every outermost closed outline is a piece.
//
// Polylines, lines, arcs, circles, ellipses and splines of all layers are joined where their ends meet; curves are
// flattened so that the outline contains the true one (rational splines and those above the third degree: to within
// the tolerance).  Blocks may insert blocks.  Loops inside a piece become its inner cuts, open lines inside
// it internal lines.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::dxf::strokes {

// Errors: those of read_tags, read_drawing and settle_unit; kUnknownFormat when nothing is closed.
[[nodiscard]] Result<Style> read_plain(std::string_view text, const ReadingOptions& options);

}  // namespace selvage::protocol::trade::dxf::strokes
