// Half pieces, which are drawn up to their mirror line: unfolded, or laid on the fold of the cloth.  Units:
// millimetres.
#pragma once

#include <vector>

#include "protocol/document/frame.h"
#include "protocol/trade/aama/blocks/pattern_block.h"

namespace selvage::protocol::trade::aama {

// The whole piece, when the outline has edges on a mirror line: outline and annotations reflected about it.  Where the
// outline leaves the line between two such edges, the whole piece has an opening, which becomes a cut-out.  A piece
// that reaches more than a millimetre beyond the line is not unfolded, with a note.
void unfold(PatternBlock& block, std::vector<Spot>& outline, std::vector<Note>& notes);

// Whether the outline is half a piece that can be laid on the fold of the cloth, which runs along the grain: one with
// edges on a mirror line along the grain, beyond which nothing lies.  A mirror line across the grain is noted.
[[nodiscard]] bool may_lie_on_fold(const PatternBlock& block, const std::vector<Spot>& outline,
                                   std::vector<Note>& notes);
// Flips the half piece if its mirror line is its upper side, so that it becomes the lower side, exactly straight.
// `turn`: from the block to the piece.  REQUIRES: may_lie_on_fold of the block.
void lay_on_fold(const PatternBlock& block, const document::Frame& turn, PatternPiece& piece);

}  // namespace selvage::protocol::trade::aama
