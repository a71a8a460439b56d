// Separation: an overlapping marker in, a valid one out, with the least motion that the rounds find [Li94 5.2]; what
// cannot be parted is named [Li94 7.9], or popped out [Li94 10].
//
// Method.  Each round aims every overlapping pair at a point on the boundary of its Minkowski sum and solves one linear
// program: the sum of |dx| + |dy| from where the pieces were, rows that may be broken at a price, and a length that may
// be overdrawn at a price and is paid back in later rounds.  Pieces outside the strip's width are put back to its edge
// first. Laws.  (1) `apart` is proved in integers.  (2) The marker is never longer than (1 + grow) times what it was,
// nor than the cloth.  (3) Locked pieces stay to the lattice unit.  (4) Same input and settings, same answer, whatever
// the cache holds. (5) An answer that is not apart overlaps no more, in the sum of depths, than the input once put
// back.
// Asked to stop, it measures no more overlaps: it hands back the best that it has seen, which is the input put back
// when it has seen no other.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/lp/solver/solve.h"
#include "core/marker/validity.h"
#include "core/motion/repair/motion_result.h"
#include "core/motion/repair/separation_target.h"
#include "core/motion/separation/tuning.h"

namespace selvage::motion::separation {

struct SeparationSettings {
  int rounds{60};  // at most this many, and as many again after each piece popped out
  double grow{};   // the part of its length that may be added; 0: the length is held
  repair::TargetRule target{repair::TargetRule::kNearest};
  bool pop_out{};  // leave out the pieces that hold up the rest
  lp::solver::SolverChoice solver{lp::solver::SolverChoice::kAutomatic};
  SeparationTuning tuning{};
  friend bool operator==(const SeparationSettings&, const SeparationSettings&) = default;
};

// `length_before` is that of the input once what lies outside the strip is put back to its edge; nothing is repaired
// beforehand.
struct Separation : repair::MotionResult {
  bool apart{};           // all pieces are separated: the marker is valid; cancelled: as far as it was checked
  double moved{};         // the sum of |dx| + |dy| over all pieces; lattice units
  Coord farthest_move{};  // the largest |dx| or |dy| of a piece; lattice units
  std::vector<marker::Overlap> remaining;  // pieces of `marker`; empty when apart; stopped: perhaps not measured
  std::vector<PieceId> popped;             // pieces of the input, in the order they were popped out; not in `marker`
};

// Errors: kOutsideStrip for a locked piece outside the strip; kOutOfRange for a grow below 0 or not finite.
[[nodiscard]] Result<Separation> separate(const Marker& start, const SeparationSettings& settings,
                                          const scene::Run& run);

}  // namespace selvage::motion::separation
