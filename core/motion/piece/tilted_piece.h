// One piece tilted: how far it may, where it then lies, and whether it can still be cut.  Shared by both ways of
// tilting.
#pragma once

#include "core/marker/placed_pieces.h"
#include "core/model/position_model.h"

namespace selvage::motion::piece {

// How far a piece may tilt either way, counter-clockwise: its shape's limit, or as far as it is tilted now when that is
// more.  Pieces locked in any way, or of
// a group, have their present tilt only.
struct TiltRange {
  Angle least, most;
};
[[nodiscard]] TiltRange tilt_range(const Marker& marker, PieceId piece);

// A piece turned about its pivot to the given tilt, to the nearest lattice point.  `from`: the piece where it lies.
[[nodiscard]] Piece tilted(const Piece& piece, const geometry::PlacedPolygon& from, Angle tilt);
// True when the piece's outline, rounded in its orientation, is still a polygon, and not wider than the strip's room.
[[nodiscard]] bool is_cuttable(const Marker& marker, const Piece& piece);
// How a piece's position must move for its pivot (core/model/tilt_rows.h) to stay when it turns about it.
[[nodiscard]] RealVec held_pivot(const geometry::PlacedPolygon& piece, Angle turn);

}  // namespace selvage::motion::piece
