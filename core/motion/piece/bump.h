// Bumping: one piece, or the rigid group that it is of, moves in a direction as far as it can, sliding along what it
// meets, while everything else stays [Li94 4.2.3].  Two variables: no linear program, only half-planes.
#pragma once

#include "core/base/result.h"
#include "core/motion/piece/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::piece {

struct Bump {
  scene::StopReason reason{};           // kWorkLimit: it went round so many corners that it may not be at the end
  Vec at;                               // where the piece ends up; proved valid
  double gain{};                        // how far it came in the direction, lattice units; never negative
  std::vector<std::uint32_t> touching;  // the pieces that hold it there
};

// The local optimum of the direction (dx, dy), which need not have unit length: no way of sliding leads farther by more
// than rounding.  A fixed piece, or the direction (0, 0), stays; one locked on an axis slides along the other.  The
// strip's right edge is the marker's present end, or the cloth's when it has one.  A marker mirrored across the strip
// gives the mirrored answer to the lattice unit, unless the piece goes along the very middle of the strip and could
// pass a corner on either side. REQUIRES: the scene's pieces are valid.
[[nodiscard]] Bump bump(const scene::Scene& scene, std::uint32_t piece, double dx, double dy,
                        const BumpTuning& tuning = {});

struct BumpedMarker : repair::MotionResult {
  Bump bump;
};
// The same for a marker as it comes: small overlaps are healed first (core/motion/heal.h).
// REQUIRES: the piece is one of the marker's, dx and dy are finite.  Errors: those of heal.
[[nodiscard]] Result<BumpedMarker> repair_and_bump(const Marker& start, PieceId piece, double dx, double dy,
                                                   const scene::Run& run);
// The same, of a marker that is laid out already: where that is known to be valid nothing of it is proved again.
[[nodiscard]] Result<BumpedMarker> repair_and_bump(const Marker& start, const scene::LaidOut& laid_out, PieceId piece,
                                                   double dx, double dy, const scene::Run& run);

}  // namespace selvage::motion::piece
