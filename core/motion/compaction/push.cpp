#include "core/motion/compaction/push.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/motion/step/position_step.h"
#include "core/scene/scene.h"

namespace selvage::motion::compaction {
Result<step::Goal> pushing_goal(std::span<const Force> forces, std::size_t pieces) {
  step::Goal goal{std::vector<RealVec>(pieces), 0, kPushPenalty};
  double largest = 0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Force& force = forces[k];
    const std::string field = "/forces/" + std::to_string(k);
    if (force.piece.value >= pieces) {
      return Error{ErrorCode::kOutOfRange,
                   "force on piece number " + std::to_string(force.piece.value) + " of " + std::to_string(pieces),
                   field};
    }
    if (!std::isfinite(force.x) || !std::isfinite(force.y)) {
      return Error{ErrorCode::kOutOfRange, "a force must be finite", field};
    }
    RealVec& sum = goal.force[force.piece.value];
    sum = {sum.x + force.x, sum.y + force.y};
    largest = std::max({largest, std::abs(sum.x), std::abs(sum.y)});
  }
  if (largest > 0) {
    for (RealVec& force : goal.force) force = {force.x / largest, force.y / largest};
  }
  return goal;
}

Result<Push> push(const Marker& start, std::span<const Force> forces, const CompactionSettings& settings,
                  const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  const auto goal = pushing_goal(forces, start.pieces.size());
  if (!goal) return goal.error();
  return repair::repaired_and<Push>(start, run, [&](scene::Scene& scene, Push& pushed) {
    const Progress progress = improve(scene, *goal, settings, run);
    record(progress, pushed);
    pushed.gain = progress.gain;
  });
}

std::vector<Force> gravity(const Marker& marker, double x, double y) {
  std::vector<Force> forces;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) forces.push_back({PieceId{i}, x, y});
  return forces;
}

}  // namespace selvage::motion::compaction
