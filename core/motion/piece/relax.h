// Relaxation: one piece to where it has most room, everything else still [Li94 6.1].  Room is the largest square in
// which its position may be chosen freely.  Three variables: no linear program (core/motion/largest_square.h).
#pragma once

#include "core/motion/piece/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::piece {

struct Relaxation {
  Piece piece;       // moved, and tilted; proved valid among the others
  double freedom{};  // it may move by so much along both axes at once, either way; lattice units
};

// Translational relaxation [Li94 6.1.1], from where the piece lies.  The strip ends where the marker does.  A local
// optimum: the free regions are chosen anew about each better place.
// REQUIRES: the scene's pieces are valid.  A piece locked in any way, or of a group, stays.
[[nodiscard]] Relaxation relax(const scene::Scene& scene, std::uint32_t piece, const RelaxTuning& tuning = {});

// Rotational relaxation [Li94 6.1.2]: of `tilts` tilts evenly spaced over the piece's range, and its present one, the
// one with most freedom.  Never less than it has now, up to rounding.
[[nodiscard]] Relaxation relax_tilted(const scene::Scene& scene, std::uint32_t piece, int tilts,
                                      const RelaxTuning& tuning = {});

struct RelaxedMarker : repair::MotionResult {
  Relaxation relaxation;
};
// The same for a marker as it comes in: small overlaps are repaired first.  With `tilts` 0 the piece keeps its tilt.
// REQUIRES: the piece is one of the marker's.  Errors: those of repair_overlaps.
[[nodiscard]] Result<RelaxedMarker> repair_and_relax(const Marker& start, PieceId piece, int tilts,
                                                     const scene::Run& run);

}  // namespace selvage::motion::piece
