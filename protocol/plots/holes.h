// Pieces with holes: where a label lies on the material, and what lies in a hole and so has to be cut first.
// Units: millimetres.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

struct LabelPlace {
  Spot middle;
  double height{};  // of the line; 0 where nothing fits
  bool upright{};   // the text runs along y
};
// The best place for a label on the piece, in none of its holes.  `aspect`: the label's width over its height;
// `largest`: the height wanted.
[[nodiscard]] LabelPlace label_place(const SheetPiece& piece, double aspect, double largest);

// For each piece, those that lie in its holes.  A knife cuts them first: what has been cut out moves, and what lies in
// it as well.
[[nodiscard]] std::vector<std::vector<std::size_t>> pieces_in_holes(const Sheet& sheet);

}  // namespace selvage::protocol::plots
