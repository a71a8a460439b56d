// The properties of a piece in the texts of its block: name, quantity, material and so on.
#pragma once

#include <string>
#include <vector>

#include "protocol/trade/aama/blocks/pattern_block.h"

namespace selvage::protocol::trade::aama {

// The value of a key, or an empty text.
[[nodiscard]] const std::string& text_or_empty(const Texts& texts, const std::string& key);

// The text as JSON, shortened if it is long; for messages.
[[nodiscard]] std::string in_quotes(const std::string& text);

// The piece without its size, outline and annotations.  A quantity that is missing or not understood is 1, with a note.
[[nodiscard]] PatternPiece described(const PatternBlock& block, const std::string& name, std::vector<Note>& notes);

// Adds a note when the piece is so small or so large that the file's unit may be wrong: outside 10 mm to 5 m.
void check_extent(const PatternPiece& piece, std::vector<Note>& notes);

}  // namespace selvage::protocol::trade::aama
