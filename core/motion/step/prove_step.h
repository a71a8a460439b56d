// From the real displacements of a solution to a step that is proved: rounded to the lattice, checked exactly, and
// shortened where rounding makes pieces collide [Li94 4.1.4].
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/marker/placed_pieces.h"
#include "core/motion/step/near_pairs.h"

namespace selvage::motion::step {

struct ProvedStep {
  // The pieces after the step, no two of which collide, and the displacements before rounding; nothing when no fraction
  // of the step could be proved.
  std::optional<marker::PlacedPieces> moved;
  std::vector<RealVec> displacements;
  // Otherwise the pairs that collide after the whole step, sorted.
  std::vector<marker::PiecePair> conflicts;
};

// Tries the fractions in turn; the first is 1.  A collision of a pair that is not modelled does not come from rounding:
// shorter steps are then not tried.
[[nodiscard]] ProvedStep prove_step(const marker::PlacedPieces& pieces, const std::vector<RealVec>& displacements,
                                    const PairSet& modelled, std::span<const double> fractions,
                                    const Executor& executor);

// The largest valid step among half the displacements, a quarter, and so on; nothing when none of them is valid.  Once
// no piece moves farther than half of the trust radius, only rounding can make a step invalid: pairs that were not
// modelled cannot meet.
[[nodiscard]] ProvedStep halve_until_valid(const marker::PlacedPieces& pieces,
                                           const std::vector<RealVec>& displacements, int halvings,
                                           const Executor& executor);

}  // namespace selvage::motion::step
