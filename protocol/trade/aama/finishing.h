// Converts a block as it was drawn to a piece as it is cut: boundary, scale, grain.  Units:
// millimetres.
#pragma once

#include <optional>
#include <vector>

#include "protocol/document/frame.h"
#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::aama {

// Every coordinate times `factor`.
void scale(PatternBlock& block, double factor);

// The largest closed loop of layer 1, without repeated vertices.  Oddities are noted.  Errors: kTooFewVertices when the
// largest is open, its ends more than a millimetre apart.
[[nodiscard]] Result<std::vector<Spot>> boundary_of(const PatternBlock& block, std::vector<Note>& notes);

// The piece's mirror image about its grain.
void mirror_piece(PatternPiece& piece);

// By how many degrees the piece must be turned for its grain to run along +x, from the line's start to its end; more
// than -180, at most 180.  A missing grain line is noted, and so is a rotation.
[[nodiscard]] double turn_of_grain(const PatternBlock& block, std::vector<Note>& notes);

}  // namespace selvage::protocol::trade::aama
