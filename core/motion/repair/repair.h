// Repair: separates the small overlaps that the rounding of other programs leaves, with the least motion, before a
// motion begins.  Model: the position model, with the nearest boundary point of each overlapping pair's Minkowski sum
// as target and the sum of all |dx| + |dy| as objective [Li94 5.2].
#pragma once

#include "core/base/result.h"
#include "core/motion/repair/tuning.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::repair {

inline constexpr double kRepairLimit = 1e-4;  // of the strip's width; deeper overlaps are refused

struct Repair {
  std::size_t pairs{};       // pairs found that overlapped or were too close
  std::size_t protruding{};  // pieces that left the strip
  double deepest{};          // the deepest of both; lattice units
  Coord farthest_move{};     // the largest |dx| or |dy| of a piece; lattice units
  Coord lengthened{};        // how much the marker grew: only when there was no room within its length; lattice units
};

// Leaves the scene's pieces valid, proved in integers; does nothing when they are valid already.  On an error the
// pieces are where they were.
// Errors: kMarkerOverlaps, kOutsideStrip (deeper than the limit: names the pieces and the depth), kRepairFailed,
// kStoppedEarly.
[[nodiscard]] Result<Repair> repair_overlaps(scene::Scene& scene, const scene::Run& run,
                                             const RepairTuning& tuning = {});

}  // namespace selvage::motion::repair
