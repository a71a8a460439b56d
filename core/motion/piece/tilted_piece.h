// Tilting one piece: the allowed range, the position after a tilt, and whether the piece can still be cut.  Shared by
// both methods of tilting.
#pragma once

#include "core/marker/placed_pieces.h"
#include "core/model/position_model.h"

namespace selvage::motion::piece {

// The tilts that a piece may have, counter-clockwise: up to its shape's limit in both directions, or up to its present
// tilt when that is larger.  A piece that is locked in any way, or in a group, keeps its present tilt.
struct TiltRange {
  Angle least, most;
};
[[nodiscard]] TiltRange tilt_range(const Marker& marker, PieceId piece);

// A piece turned about its pivot to the given tilt, to the nearest lattice point.  `from`: the piece where it lies.
[[nodiscard]] Piece tilted(const Piece& piece, const geometry::PlacedPolygon& from, Angle tilt);
// True when the piece's outline, rounded in its orientation, is still a polygon and not wider than the strip's room.
[[nodiscard]] bool is_cuttable(const Marker& marker, const Piece& piece);
// The displacement of a piece's position that keeps its pivot (core/model/tilting/tilt_rows.h) in place when it turns.
[[nodiscard]] RealVec held_pivot(const geometry::PlacedPolygon& piece, Angle turn);

}  // namespace selvage::motion::piece
