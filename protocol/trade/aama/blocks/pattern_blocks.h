// All pieces of a pattern file as they are drawn: its blocks, or what ENTITIES draws if there are none.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "protocol/trade/aama/blocks/block_roles.h"
#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/dxf/drawing.h"

namespace selvage::protocol::trade::aama::blocks {

struct PatternBlocks {
  std::vector<PatternBlock> pieces;  // empty: the file draws no boundary
  std::vector<PieceInsert> inserts;  // of the pieces
  bool loose{};                      // they are not blocks but drawn in ENTITIES
};

// `millimetre` is one in the file's unit.  Oddities are noted in `reading`, whose `blocks` are set meanwhile.
// Errors: kOutOfRange when blocks insert one another too often, or curves need too many chords.
[[nodiscard]] Result<PatternBlocks> read_pattern_blocks(const dxf::DxfDrawing& drawing, double millimetre,
                                                        BlockReading& reading);

}  // namespace selvage::protocol::trade::aama::blocks
