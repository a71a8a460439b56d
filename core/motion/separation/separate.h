// Separation: turns an overlapping marker into a valid one with the least motion that its rounds find [Li94 5.2].
// Pieces that cannot be separated are reported [Li94 7.9] or removed [Li94 10].
//
// Method.  Each round aims every overlapping pair at a point on the boundary of its Minkowski sum and solves one linear
// program: it minimises the sum of |dx| + |dy| from where the pieces were; its rows may be violated at a price; the
// marker may become longer than allowed at a price, which later rounds take back.  Pieces outside the strip are first
// moved to its edge.  Overlaps that come only from rounding are repaired (core/motion/repair/repair.h).
// Laws.  (1) `apart` is proved in integers.  (2) The marker is never longer than (1 + grow) times its length before,
// nor than the cloth.  (3) Locked pieces stay in place to the lattice unit.  (4) The same input and settings give the
// same answer, whatever the cache holds.  (5) If pieces still overlap, the sum of depths is no larger than in the input
// with its pieces moved into the strip.  When cancelled, it skips the final overlap report and returns the best marker
// found so far, put back into the allowed length, or the input with its pieces moved into the strip if that overlaps
// less.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/base/result.h"
#include "core/lp/solver/solve.h"
#include "core/marker/validity.h"
#include "core/motion/repair/motion_result.h"
#include "core/motion/repair/separation_target.h"
#include "core/motion/separation/tuning.h"

namespace selvage::motion::separation {

struct SeparationSettings {
  int rounds{60};  // at most this many, and as many again after each piece that is removed
  double grow{};   // the part of its length by which the marker may grow; 0: fixed length
  repair::TargetRule target{repair::TargetRule::kNearest};
  bool pop_out{};  // remove the pieces that prevent separation
  double small{};  // pieces up to this area, in square lattice units, are removed before others
  std::size_t most_popped{std::numeric_limits<std::size_t>::max()};  // it gives up when more would have to be removed
  lp::solver::SolverChoice solver{lp::solver::SolverChoice::kAutomatic};
  SeparationTuning tuning{};
  friend bool operator==(const SeparationSettings&, const SeparationSettings&) = default;
};

// `length_before` is that of the input once pieces outside the strip have been put back to its edge; nothing is
// repaired beforehand.
struct Separation : repair::MotionResult {
  bool apart{};           // all pieces are separated: the marker is valid; cancelled: as far as it was checked
  double moved{};         // the sum of |dx| + |dy| over all pieces; lattice units
  Coord farthest_move{};  // the largest |dx| or |dy| of a piece; lattice units
  std::vector<marker::Overlap> remaining;  // pairs of `marker`; empty when apart; when cancelled, depths may be missing
  std::vector<PieceId> popped;             // pieces of the input that were removed, in this order; not in `marker`
};

// Errors: kOutsideStrip for a locked piece outside the strip; kOutOfRange for a grow below 0 or not finite;
// kMarkerOverlaps when marker::kMostConflicts pairs of pieces or more overlap or are too close.
[[nodiscard]] Result<Separation> separate(const Marker& start, const SeparationSettings& settings,
                                          const scene::Run& run);

}  // namespace selvage::motion::separation
