// From a block as it was drawn to a piece as it is cut: boundary, unfolding, grain.
// Units: millimetres.
#pragma once

#include <optional>
#include <vector>

#include "protocol/trade/aama/pattern_block.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::aama {

// Every coordinate times `factor`.
void scale(PatternBlock& block, double factor);

// The largest closed loop of layer 1, without repeated vertices.  What is odd about it is noted.
// Errors: kTooFewVertices when the largest is open, its ends more than a millimetre apart.
[[nodiscard]] Result<std::vector<Spot>> boundary_of(const PatternBlock& block, std::vector<Note>& notes);

// The whole piece, when the outline has edges on a mirror line: outline and annotations reflected about it.
void unfold(PatternBlock& block, std::vector<Spot>& outline, std::vector<Note>& notes);

// By how many degrees the piece must be turned for its grain to run along +x, from the line's start to its end; more
// than -180, at most 180.  A grain that is not there is noted, and so is a turn.
[[nodiscard]] double turn_of_grain(const PatternBlock& block, std::vector<Note>& notes);

}  // namespace selvage::protocol::trade::aama
