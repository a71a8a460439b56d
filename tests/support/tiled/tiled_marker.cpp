#include "tests/support/tiled/tiled_marker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/motion/separation/separate.h"

namespace selvage::test {

Marker loosened(const Marker& marker, double slack) {
  Marker loose = marker;
  loose.strip.longest.reset();
  const marker::PlacedPieces pieces{marker};
  for (std::size_t i = 0; i < loose.pieces.size(); ++i) {
    loose.pieces[i].at.x += std::llround(slack * static_cast<double>(pieces.box(i).low.x));
  }
  if (is_valid(loose)) return loose;
  SumCache sums;
  motion::separation::SeparationSettings settings;
  settings.grow = slack;
  auto separation = separate(loose, settings, {sums});
  if (!separation || !separation->apart) throw std::runtime_error{"a marker that cannot be loosened"};
  return std::move(separation->marker);
}

Marker tiled(const Marker& marker, std::size_t pieces) {
  Marker tiles = marker;
  tiles.pieces.clear();
  tiles.strip.longest.reset();
  const marker::PlacedPieces placed{marker};
  std::vector<std::size_t> order(marker.pieces.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return placed.box(a).low.x < placed.box(b).low.x; });
  for (Coord tile = 0; tiles.pieces.size() < pieces; ++tile) {
    for (std::size_t k = 0; k < order.size() && tiles.pieces.size() < pieces; ++k) {
      Piece piece = marker.pieces[order[k]];
      piece.at.x += tile * (placed.length() + placed.widest_spacing());
      piece.id += "@" + std::to_string(tile);
      if (!piece.group.empty()) piece.group += "@" + std::to_string(tile);
      tiles.pieces.push_back(std::move(piece));
    }
  }
  return tiles;
}

}  // namespace selvage::test
