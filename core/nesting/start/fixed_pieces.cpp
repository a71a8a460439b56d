#include "core/nesting/start/fixed_pieces.h"

#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"

namespace selvage::nesting::start {

Marker with_pieces_taken_off(const Marker& given, const layout::PieceSet& set) {
  Marker bare = given;
  bare.pieces.clear();
  bare.unplaced.clear();
  for (std::size_t i = 0; i < given.pieces.size(); ++i) {
    Piece piece = given.pieces[i];
    if (!set.fixed[i]) piece.at = {};
    (set.fixed[i] ? bare.pieces : bare.unplaced).push_back(std::move(piece));
  }
  bare.unplaced.insert(bare.unplaced.end(), given.unplaced.begin(), given.unplaced.end());
  return bare;
}

std::vector<bool> kept_where_valid(const Marker& start, const layout::PieceSet& set) {
  if (all_clear(marker::PlacedPieces{start}, start.strip)) return std::vector<bool>(start.pieces.size(), true);
  return {set.fixed.begin(), set.fixed.begin() + static_cast<std::ptrdiff_t>(start.pieces.size())};
}

}  // namespace selvage::nesting::start
