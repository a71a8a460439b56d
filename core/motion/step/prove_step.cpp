#include "core/motion/step/prove_step.h"

#include <algorithm>

#include "core/marker/clearance.h"
#include "core/model/snap.h"
#include "core/motion/step/length_mode.h"

namespace selvage::motion::step {
namespace {

marker::PlacedPieces moved_by(const marker::PlacedPieces& pieces, const std::vector<RealVec>& displacements) {
  marker::PlacedPieces moved = pieces;
  moved.move_by(model::snapped(displacements));
  return moved;
}

}  // namespace

ProvedStep prove_step(const marker::PlacedPieces& pieces, const std::vector<RealVec>& displacements,
                      const PairSet& modelled, std::span<const double> fractions, const Executor& executor) {
  ProvedStep proved;
  for (const double fraction : fractions) {
    std::vector<RealVec> part = scaled(displacements, fraction);
    marker::PlacedPieces moved = moved_by(pieces, part);
    auto conflicts = marker::conflicts(moved, executor);
    if (conflicts.empty()) return {std::move(moved), std::move(part), {}};
    if (fraction == fractions.front()) proved.conflicts = std::move(conflicts);
    const bool rounding_only = std::all_of(proved.conflicts.begin(), proved.conflicts.end(),
                                           [&](const marker::PiecePair& pair) { return modelled.contains(pair); });
    if (!rounding_only) break;
  }
  return proved;
}

ProvedStep halve_until_valid(const marker::PlacedPieces& pieces, const std::vector<RealVec>& displacements,
                             int halvings, const Executor& executor) {
  double fraction = 1;
  for (int k = 0; k < halvings; ++k) {
    fraction /= 2;
    std::vector<RealVec> part = scaled(displacements, fraction);
    marker::PlacedPieces moved = moved_by(pieces, part);
    if (marker::conflicts(moved, executor).empty()) return {std::move(moved), std::move(part), {}};
  }
  return {};
}

}  // namespace selvage::motion::step
