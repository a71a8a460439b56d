#include "core/motion/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/marker/clearance.h"
#include "core/motion/repair/faults.h"
#include "core/motion/repair/phase.h"
#include "core/motion/repair/repair_step.h"

namespace selvage::motion::repair {
namespace {

Repair report_of(const scene::Scene& scene, const std::vector<Conflict>& conflicts) {
  Repair repair;
  repair.pairs = conflicts.size();
  for (const Conflict& conflict : conflicts) repair.deepest = std::max(repair.deepest, conflict.target.depth);
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    const Coord by = protrusion(scene, i);
    repair.protruding += by > 0;
    repair.deepest = std::max(repair.deepest, static_cast<double>(by));
  }
  repair.deepest = std::max(repair.deepest, static_cast<double>(off_phase(scene)));
  for (const marker::Shade& shade : scene.pieces.shades()) {
    repair.deepest = std::max(repair.deepest, static_cast<double>(scene.pieces.excess_of(shade)));
  }
  return repair;
}

Coord farthest_move(const std::vector<Vec>& from, const marker::PlacedPieces& to) {
  Coord farthest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec move = to.at(i) - from[i];
    farthest = std::max({farthest, std::abs(move.x), std::abs(move.y)});
  }
  return farthest;
}

}  // namespace

Result<Repair> repair_overlaps(scene::Scene& scene, const scene::Run& run, const RepairTuning& tuning) {
  const std::vector<Vec> start = scene.pieces.positions();
  const Coord length = scene.pieces.length();
  const double limit = kRepairLimit * static_cast<double>(scene.marker.strip.width);
  std::vector<Conflict> conflicts = find_conflicts(scene, run);
  Repair repair = report_of(scene, conflicts);
  const auto refusal = refuse_deep(scene, conflicts, limit);
  if (refusal && !run.stopped()) return *refusal;

  if (off_phase(scene) > 0) {
    into_phase(scene);
    conflicts = find_conflicts(scene, run);
  }
  const auto repaired = [&] { return conflicts.empty() && !any_protrusion(scene); };
  for (int round = 0; round < tuning.rounds && !repaired(); ++round) {
    if (!repair_step(scene, conflicts, limit, tuning, run)) break;
    conflicts = find_conflicts(scene, run);
  }
  // When cancelled, only some of the conflicts were looked for.
  if (run.stopped() ? !all_clear(scene.pieces, scene.marker.strip) : !repaired()) {
    scene.pieces.place(start);
    if (!run.stopped()) return repair_failed(scene, conflicts);
    return Error{ErrorCode::kStoppedEarly, "stopped before the overlaps of the input were separated", "/pieces"};
  }
  repair.farthest_move = farthest_move(start, scene.pieces);
  repair.lengthened = std::max(Coord{0}, scene.pieces.length() - length);
  return repair;
}

}  // namespace selvage::motion::repair
