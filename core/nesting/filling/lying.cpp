#include "core/nesting/filling/lying.h"

namespace selvage::nesting::filling {

Marker with_lying_pieces(const Marker& all, const std::vector<bool>& lies) {
  Marker marker = all;
  marker.pieces.clear();
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    if (lies[i]) {
      marker.pieces.push_back(all.pieces[i]);
    } else {
      marker.unplaced.push_back(all.pieces[i]);
      marker.unplaced.back().at = {};
    }
  }
  return marker;
}

std::vector<bool> pieces_before(const Marker& marker, Coord last) {
  std::vector<bool> lies(marker.pieces.size());
  for (std::size_t i = 0; i < lies.size(); ++i) {
    lies[i] = marker.pieces[i].rules.zone ||
              box_of(placed_outline(marker, PieceId{static_cast<std::uint32_t>(i)})).high.x <= last;
  }
  return lies;
}

}  // namespace selvage::nesting::filling
