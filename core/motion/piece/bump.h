// Bumping: one piece, or the rigid group that it belongs to, moves in a direction as far as it can, sliding along the
// pieces that it meets, while all others stay [Li94 4.2.3].  With two variables this needs no linear program, only
// half-planes.
#pragma once

#include <stop_token>

#include "core/base/result.h"
#include "core/motion/piece/tuning.h"
#include "core/motion/repair/motion_result.h"

namespace selvage::motion::piece {

struct Bump {
  scene::StopReason reason{};     // kWorkLimit: it passed so many corners that it may not have reached the end;
                                  // kCancelled: it stopped on its way
  Vec at;                         // where the piece ends up; proved valid
  double gain{};                  // the distance moved in the direction, lattice units; never negative
  std::vector<PieceId> touching;  // the pieces that stop it there
};

// The local optimum in the direction (dx, dy), which need not have unit length: sliding farther gains no more than
// rounding.  A fixed piece stays, and with the direction (0, 0) any piece does; a piece locked on one axis slides along
// the other.  The strip ends where the marker does, or where the cloth does when that has an end.  A marker mirrored
// across the strip gives the mirrored answer to the lattice unit, unless the piece moves along the exact middle of the
// strip and could pass a corner on either side.  REQUIRES: the scene's pieces are valid.
[[nodiscard]] Bump bump(const scene::Scene& scene, PieceId piece, double dx, double dy,
                        const std::stop_token& stop = {}, const BumpTuning& tuning = {});

struct BumpedMarker : repair::MotionResult {
  Bump bump;
};
// The same for a marker as it comes in: small overlaps are repaired first (core/motion/repair/repair.h).
// REQUIRES: the piece is one of the marker's, dx and dy are finite.  Errors: those of repair_overlaps.
[[nodiscard]] Result<BumpedMarker> repair_and_bump(const Marker& start, PieceId piece, double dx, double dy,
                                                   const scene::Run& run);
// The same for a marker that is laid out already: if it is known to be valid, it is not proved again.
[[nodiscard]] Result<BumpedMarker> repair_and_bump(const Marker& start, const scene::LaidOut& laid_out, PieceId piece,
                                                   double dx, double dy, const scene::Run& run);

}  // namespace selvage::motion::piece
