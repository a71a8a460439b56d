// Pattern files without blocks: the pieces are drawn in ENTITIES, and nothing but their position tells what belongs to
// which.
//
// Every outermost closed line on layer 1 is a piece.  It has the texts, notches and lines that lie in it or within a
// millimetre of its outline; a text such as "Piece Name: FRONT" that lies outside of all belongs to the nearest one.
#pragma once

#include <vector>

#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/dxf/drawing.h"

namespace selvage::protocol::trade::aama::blocks {

// Reads them as if each piece were a block, in the order of the file; `millimetre` is one in the file's unit.  Empty if
// no line is drawn on layer 1.  Oddities are noted in `reading`.
[[nodiscard]] std::vector<PatternBlock> read_loose_pieces(const dxf::DxfDrawing& drawing, double millimetre,
                                                          BlockReading& reading);

}  // namespace selvage::protocol::trade::aama::blocks
