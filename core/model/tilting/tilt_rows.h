// The rows that keep two pieces apart while both move and tilt a little: the constraints of [Li94 6.2] between a vertex
// of one piece and an edge of the other, linearised about the present layout.
//
// Both forms, (6.2) with the edge on the second piece and (6.3) with it on the first, come to the same row once written
// about the contact: the edge's line passes the vertex c, and a turn of either piece moves its own material at c square
// to the lever from the piece's pivot.  With the normal n from the first piece to the second,
//     n . (d_q - d_p) + (n . J(c - pivot_q)) turn_q - (n . J(c - pivot_p)) turn_p >= bound,   J a quarter turn.
// What is left out is of second order: about lever * turn^2 / 2, and turn * displacement.
// Departs: pieces turn about the middle of their box, which makes the levers, and with them the errors, small.
//
// Units: lattice units, radians.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/real_vec.h"
#include "core/marker/placed_pieces.h"
#include "core/model/pair_rows.h"

namespace selvage::model::tilting {

// What a piece turns about: the middle of its box where it lies.
[[nodiscard]] RealVec pivot_of(const geometry::PlacedPolygon& piece);
// The distance of its farthest vertex from there.
[[nodiscard]] double radius_of(const geometry::PlacedPolygon& piece);

// A row of two displacements and two turns: row . + first_turn * turn_p + second_turn * turn_q >= row.bound.
struct TiltRow {
  PairRow row;
  double first_turn{}, second_turn{};
  friend bool operator==(const TiltRow&, const TiltRow&);
};

struct TiltRowSettings {
  double turn{};    // radians: at most so far does a piece turn either way
  double reach{};   // rows that have more room than this are left out
  double behind{};  // vertices may lie this far behind the edge that they are to be kept before: the pair overlaps
  Coord spacing{};
  ModelUnit unit;
};

// The rows of one pair: every half-plane of its free region at the vertex that made it, and the vertices near the same
// edge, or on the other side of the contact, that turns of this size can bring to it.  Without these, two edges that
// lie along each other would pivot about one end straight into each other.
[[nodiscard]] std::vector<TiltRow> tilt_rows(marker::PiecePair pair, const geometry::PlacedPolygon& p,
                                             const geometry::PlacedPolygon& q, std::span<const HalfPlane> region,
                                             const TiltRowSettings& settings);

// A row of one piece and an edge of the strip: nx * dx + ny * dy + turn * (its turn) >= bound.  (nx, ny): from the edge
// into the strip.
struct WallRow {
  int nx{}, ny{};
  double turn{};
  double bound{};
};
// For the vertices that can be the first to reach the edge, which bounds nx * x + ny * y from below by `edge`.
[[nodiscard]] std::vector<WallRow> wall_rows(const geometry::PlacedPolygon& piece, int nx, int ny, Coord edge,
                                             double turn);

}  // namespace selvage::model::tilting
