#include "core/packing/nearby.h"

#include "core/marker/placed_pieces.h"

namespace selvage::packing {

Nearby nearby(const Marker& whole, const std::vector<bool>& moving, const Box& box) {
  const marker::PlacedPieces pieces{whole};
  const Box near = box.grown(pieces.widest_spacing());
  Nearby part{whole, {}, {}};
  part.marker.pieces.clear();
  for (std::uint32_t k = 0; k < whole.pieces.size(); ++k) {
    const Piece& piece = whole.pieces[k];
    if (!moving[k] && piece.rules == marker::Rules{} && !pieces.box(k).touches(near)) continue;
    part.marker.pieces.push_back(piece);
    part.moving.push_back(moving[k]);
    part.place.push_back(k);
  }
  return part;
}

Marker as_part_of(Marker whole, const Nearby& nearby, const Marker& now) {
  for (std::size_t k = 0; k < nearby.place.size(); ++k) whole.pieces[nearby.place[k]] = now.pieces[k];
  return whole;
}

}  // namespace selvage::packing
