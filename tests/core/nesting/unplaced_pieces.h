// Markers whose pieces have not been nested yet.
#pragma once

#include <string>
#include <utility>

#include "core/marker/marker.h"
#include "tests/support/polygons.h"

namespace selvage::test {

// The marker with all its pieces taken off the cloth, except those that are locked or grouped.
[[nodiscard]] inline Marker taken_off(Marker marker) {
  std::vector<Piece> placed;
  for (Piece& piece : marker.pieces) {
    const bool held = piece.locked.x || piece.locked.y || !piece.group.empty();
    if (!held) piece.at = {};
    (held ? placed : marker.unplaced).push_back(std::move(piece));
  }
  marker.pieces = std::move(placed);
  return marker;
}

// A marker with this many unplaced pieces, which have the given outlines in turn, on a strip of this width and
// unlimited length.
[[nodiscard]] inline Marker unplaced_pieces(const std::vector<Polygon>& outlines, std::size_t pieces, Coord width) {
  Marker marker;
  marker.strip.width = width;
  for (const Polygon& outline : outlines) {
    marker.shapes.push_back({.id = std::to_string(marker.shapes.size()),
                             .outline = outline,
                             .rotations = {{0}, {90}, {180}, {270}},
                             .tilt_limit = {}});
  }
  for (std::size_t i = 0; i < pieces; ++i) {
    marker.unplaced.push_back({.id = std::to_string(i),
                               .shape = {static_cast<std::uint32_t>(i % outlines.size())},
                               .orientation = {},
                               .at = {}});
  }
  return marker;
}

inline constexpr Coord kWidth = 1'000'000;  // of a strip, in lattice units: a model unit is a thousand of them
inline constexpr Coord kSide = 100'000;     // of a piece, in lattice units
[[nodiscard]] inline Polygon rectangle(Coord width, Coord height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

}  // namespace selvage::test
