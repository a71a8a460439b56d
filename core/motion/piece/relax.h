// Relaxation: one piece moves to where it has most room, while all others stay [Li94 6.1].  Its room is the largest
// square in which its position may be chosen freely.  With three variables this needs no linear program solver
// (largest_square.h).
#pragma once

#include <stop_token>

#include "core/motion/piece/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::piece {

struct Relaxation {
  Piece piece;       // moved, and tilted; proved valid among the others
  double freedom{};  // half the side of the largest square of free translations; lattice units
};

// Translational relaxation [Li94 6.1.1], from where the piece lies.  The strip ends where the marker does.  The result
// is a local optimum: the free regions are chosen anew about each better position.
// When cancelled, it is the best position so far.
// REQUIRES: the scene's pieces are valid.  A piece that is locked in any way, or in a group, stays.
[[nodiscard]] Relaxation relax(const scene::Scene& scene, PieceId piece, const std::stop_token& stop = {},
                               const RelaxTuning& tuning = {});

// Rotational relaxation [Li94 6.1.2]: of `tilts` tilts evenly spaced over the piece's range, and its present one, the
// one with most freedom.  Apart from rounding, the freedom never becomes less than at the present tilt.  When
// cancelled, it is the best of the tilts so far.
[[nodiscard]] Relaxation relax_tilted(const scene::Scene& scene, PieceId piece, int tilts,
                                      const std::stop_token& stop = {}, const RelaxTuning& tuning = {});

struct RelaxedMarker : repair::MotionResult {
  Relaxation relaxation;
};
// The same for a marker as it comes in: small overlaps are repaired first.  With `tilts` 0 the piece keeps its tilt.
// REQUIRES: the piece is one of the marker's.  Errors: those of repair_overlaps.
[[nodiscard]] Result<RelaxedMarker> repair_and_relax(const Marker& start, PieceId piece, int tilts,
                                                     const scene::Run& run);

}  // namespace selvage::motion::piece
