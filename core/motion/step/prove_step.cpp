#include "core/motion/step/prove_step.h"

#include <algorithm>

#include "core/marker/clearance.h"
#include "core/model/snap.h"

namespace selvage::motion::step {

ProvedStep prove_step(const marker::PlacedPieces& pieces, const std::vector<RealVec>& displacements,
                      const PairSet& modelled, std::span<const double> fractions, const Executor& executor) {
  ProvedStep proved;
  for (const double fraction : fractions) {
    std::vector<RealVec> scaled = displacements;
    for (RealVec& d : scaled) d = {d.x * fraction, d.y * fraction};
    marker::PlacedPieces moved = pieces;
    moved.move_by(model::snapped(scaled));
    auto conflicts = marker::conflicts(moved, executor);
    if (conflicts.empty()) return {std::move(moved), std::move(scaled), {}};
    if (fraction == fractions.front()) proved.conflicts = std::move(conflicts);
    const bool rounding_only = std::all_of(proved.conflicts.begin(), proved.conflicts.end(),
                                           [&](const marker::PiecePair& pair) { return modelled.contains(pair); });
    if (!rounding_only) break;
  }
  return proved;
}

}  // namespace selvage::motion::step
