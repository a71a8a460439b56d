#include "core/nesting/start/shelves.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

namespace selvage::nesting::start {
namespace {

// A piece that is to be placed, in the orientation in which it is shortest.
struct Boxed {
  std::size_t piece{};
  Orientation orientation;
  Box box;
  marker::FoldEdge fold{};  // if it has to lie on the fold
};

Boxed shortest(const Marker& marker, const layout::PieceSet& set, std::size_t piece) {
  Boxed best;
  for (const layout::Turned& turned : set.kind(piece).turned) {
    const Polygon outline = oriented(marker.shapes[set.kind(piece).shape.value].outline, turned.orientation);
    const Box box = box_of(outline);
    if (best.box != Box{} && box.width() >= best.box.width()) continue;
    best = {piece, turned.orientation, box, fold_edge(marker.pieces[piece].rules, outline, marker.strip)};
  }
  return best;
}

// Bands that end come first and those that begin late come last; pieces of a shade follow each other.  By falling
// width, so that the boxes of a column are nearly as wide as the column.
void sort(std::vector<Boxed>& boxes, const Marker& marker) {
  const auto key = [&marker](const Boxed& boxed) {
    const marker::Rules& rules = marker.pieces[boxed.piece].rules;
    const std::string_view shade = marker.shade ? std::string_view{rules.shade} : std::string_view{};
    return std::tuple{rules.to.value_or(kLatticeLimit), rules.from.value_or(0), shade, -boxed.box.width()};
  };
  std::stable_sort(boxes.begin(), boxes.end(), [&](const Boxed& a, const Boxed& b) { return key(a) < key(b); });
}

// The column that is being filled.
struct Column {
  Coord x{};
  Coord width{};
  std::optional<Coord> top{};  // of the boxes in it, with the clearance; none: it is empty

  // The y at which the piece lies on the others, by its rules; nothing where the column has no room for it.
  [[nodiscard]] std::optional<Coord> place_for(const marker::Rules& rules, const Boxed& boxed,
                                               const Strip& strip) const {
    const Coord height = boxed.box.height();
    const Box room = room_for(rules, height, boxed.fold, strip, kLatticeLimit);
    if (!top) return room.low.y;
    const Coord y = std::max(*top, room.low.y);
    return y + height > room.high.y ? std::nullopt : std::optional{y};
  }
};

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
  sort(boxes, marker);
  Column column{x};
  for (const Boxed& boxed : boxes) {
    Piece& piece = marker.pieces[boxed.piece];
    auto y = column.place_for(piece.rules, boxed, marker.strip);
    if (!y) {
      column = {column.x + column.width + clearance};
      y = column.place_for(piece.rules, boxed, marker.strip);
    }
    const Coord left = std::max(column.x, piece.rules.from.value_or(0));
    column.width = std::max(column.width, left + boxed.box.width() - column.x);
    if (column.x + column.width >= kLatticeLimit) {
      return Error{ErrorCode::kBeyondLattice, "the pieces would reach beyond the marker's lattice", "/resolution"};
    }
    piece.orientation = boxed.orientation;
    piece.at = Vec{left, *y} - boxed.box.low;
    column.top = *y + boxed.box.height() + clearance;
  }
  return marker;
}

}  // namespace selvage::nesting::start
