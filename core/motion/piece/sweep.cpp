#include "core/motion/piece/sweep.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/motion/piece/bump.h"

namespace selvage::motion::piece {
namespace {

// From left to right; ties by piece.
std::vector<std::uint32_t> sweep_order(const marker::PlacedPieces& pieces) {
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return pieces.box(a).low.x < pieces.box(b).low.x; });
  return order;
}

// Bumps every piece once; returns the sum of the distances moved.
double sweep(scene::Scene& scene, const scene::Run& run) {
  double gain = 0;
  for (const std::uint32_t piece : sweep_order(scene.pieces)) {
    run.observer.on_stage(scene::Stage::kSolve);
    if (run.stopped()) break;
    const Bump bumped = bump(scene, PieceId{piece}, -1, 0, run.stop);
    gain += bumped.gain;
    scene.shift(PieceId{piece}, bumped.at - scene.pieces.at(piece));
  }
  return gain;
}

}  // namespace

scene::StopReason sweep_until_still(scene::Scene& scene, const SweepSettings& settings, const scene::Run& run,
                                    int& sweeps) {
  const double least = settings.least_gain * static_cast<double>(scene.marker.strip.width);
  const int last = sweeps + settings.sweeps;
  while (sweeps < last) {
    if (run.stopped()) return scene::StopReason::kCancelled;
    const double gain = sweep(scene, run);
    run.observer.on_stage(scene::Stage::kOther);
    ++sweeps;
    run.observer.on_round({sweeps, scene.pieces.length()});
    if (run.stopped()) return scene::StopReason::kCancelled;
    if (gain <= least) return scene::StopReason::kConverged;
  }
  return scene::StopReason::kWorkLimit;
}

}  // namespace selvage::motion::piece
