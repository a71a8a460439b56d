// The rows that keep two pieces apart while both move and tilt a little: the constraints of [Li94 6.2] between a vertex
// of one piece and an edge of the other, linearised about the present layout.
//
// Both forms, (6.2) with the edge on the second piece and (6.3) with it on the first, lead to the same row when they
// are written about the contact point c: the edge's line passes through the vertex c, and turning a piece moves its
// material at c perpendicular to the lever arm from the piece's pivot.  With the normal n from the first piece to the
// second,
//     n . (d_q - d_p) + (n . J(c - pivot_q)) turn_q - (n . J(c - pivot_p)) turn_p >= bound,   J a quarter turn.
// The terms left out are of second order: about lever * turn^2 / 2, and turn * displacement.
// Departs: pieces turn about the middle of their box, so that the lever arms, and with them the errors, are small.
//
// Units: lattice units, radians.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/marker/placed_pieces.h"
#include "core/model/pair_rows.h"

namespace selvage::model::tilting {

// The point that a piece turns about: the middle of its box where it lies.
[[nodiscard]] RealVec pivot_of(const geometry::PlacedPolygon& piece);
// The distance of the piece's farthest vertex from there.
[[nodiscard]] double radius_of(const geometry::PlacedPolygon& piece);

// A row of two displacements and two turns: row . + first_turn * turn_p + second_turn * turn_q >= row.bound.
struct TiltRow {
  PairRow row;
  double first_turn{}, second_turn{};
  friend bool operator==(const TiltRow&, const TiltRow&);
};

struct TiltRowSettings {
  double turn{};    // radians: the most that a piece turns either way
  double reach{};   // lattice units: rows with more room than this are left out
  double behind{};  // lattice units: how far vertices may lie behind the edge that keeps them out; 0 unless the pair
                    // overlaps or may overlap
  Coord spacing{};
  ModelUnit unit;
};

// The rows of one pair: one for every half-plane of its free region, at the vertex that made it, and one for each
// vertex near the same edge, or on the other side of the contact, that turns of this size can bring to it.  Without the
// latter, two edges that lie along each other would pivot about one end into each other.
[[nodiscard]] std::vector<TiltRow> tilt_rows(marker::PiecePair pair, const geometry::PlacedPolygon& p,
                                             const geometry::PlacedPolygon& q, std::span<const HalfPlane> region,
                                             const TiltRowSettings& settings);

// A row of one piece and an edge of the strip: nx * dx + ny * dy + turn * (the piece's turn) >= bound.  (nx, ny) points
// from the edge into the strip.
struct WallRow {
  int nx{}, ny{};
  double turn{};
  double bound{};
};
// One row for each vertex that can be the first to reach the edge, which bounds nx * x + ny * y from below by `edge`.
[[nodiscard]] std::vector<WallRow> wall_rows(const geometry::PlacedPolygon& piece, int nx, int ny, Coord edge,
                                             double turn);

}  // namespace selvage::model::tilting
