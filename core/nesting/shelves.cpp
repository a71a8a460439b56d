#include "core/nesting/shelves.h"

#include <algorithm>
#include <cstdint>

namespace selvage::nesting {
namespace {

// A piece that is to be placed, in the orientation in which it is shortest.
struct Boxed {
  std::size_t piece{};
  Orientation orientation;
  Box box;
};

Boxed shortest(const Marker& marker, const layout::PieceSet& set, std::size_t piece) {
  Boxed best;
  for (const layout::Turned& turned : set.kind(piece).turned) {
    const Box box = box_of(oriented(marker.shapes[set.kind(piece).shape.value].outline, turned.orientation));
    if (best.box == Box{} || box.width() < best.box.width()) best = {piece, turned.orientation, box};
  }
  return best;
}

}  // namespace

Result<Marker> on_shelves(const Marker& start, const layout::PieceSet& set, const std::vector<bool>& kept) {
  Marker marker = start;
  marker.pieces.insert(marker.pieces.end(), start.unplaced.begin(), start.unplaced.end());
  marker.unplaced.clear();
  Coord clearance = marker.spacing;
  Coord x = marker.strip.margin;
  std::vector<Boxed> boxes;
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    clearance = std::max(clearance, 2 * marker.pieces[i].buffer);
    if (i >= kept.size() || !kept[i]) {
      boxes.push_back(shortest(marker, set, i));
    } else {
      x = std::max(x, box_of(placed_outline(marker, PieceId{static_cast<std::uint32_t>(i)})).high.x);
    }
  }
  if (x > marker.strip.margin) x += clearance;
  // By falling width, so that the boxes of a column are nearly as wide as the column.
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const Boxed& a, const Boxed& b) { return a.box.width() > b.box.width(); });
  const Box room = marker.strip.room(kLatticeLimit);
  Coord y = room.low.y;
  Coord column = 0;  // its width
  for (const Boxed& boxed : boxes) {
    if (y + boxed.box.height() > room.high.y) {
      x += column + clearance;
      y = room.low.y;
      column = 0;
    }
    column = std::max(column, boxed.box.width());
    if (x + column >= kLatticeLimit) {
      return Error{ErrorCode::kBeyondLattice, "the pieces would reach beyond the marker's lattice", "/resolution"};
    }
    Piece& piece = marker.pieces[boxed.piece];
    piece.orientation = boxed.orientation;
    piece.at = Vec{x, y} - boxed.box.low;
    y += boxed.box.height() + clearance;
  }
  return marker;
}

}  // namespace selvage::nesting
