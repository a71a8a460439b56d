// How the INSERTs of a pattern file place its blocks.  The standard inserts every block once, as drawn; some writers
// scale the blocks, mirror them, insert them several times, or not at all.  Units: millimetres.
#pragma once

#include <vector>

#include "protocol/trade/aama/blocks/block_roles.h"
#include "protocol/trade/aama/blocks/pattern_block.h"

namespace selvage::protocol::trade::aama {

// Counts the INSERTs of each block and scales a block that they all scale by the same factor.  Everything that is not
// one INSERT of a block as drawn is noted.
void follow_inserts(const std::vector<blocks::PieceInsert>& inserts, Encoding encoding,
                    std::vector<PatternBlock>& blocks, std::vector<Note>& notes);

}  // namespace selvage::protocol::trade::aama
