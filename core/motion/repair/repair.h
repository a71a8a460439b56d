// Healing: parts the small overlaps that other programs' rounding leaves, by least motion, before anything else is done
// with a marker.  Model: the position model with the nearest boundary point of each overlapping pair's Minkowski sum as
// target and the sum of all |dx| + |dy| as objective [Li94 5.2].
#pragma once

#include <stop_token>

#include "core/base/result.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::repair {

inline constexpr double kHealingLimit = 1e-4;  // of the strip's width; deeper overlaps are refused

struct Repair {
  std::size_t pairs{};       // overlapping (or too close) pairs found
  std::size_t protruding{};  // pieces that left the strip
  double deepest{};          // the deepest of them; lattice units
  Coord farthest_move{};     // the largest |dx| or |dy| of a piece; lattice units
  Coord lengthened{};        // by how much the marker grew: only when its overlaps cannot be parted within its length
};

// Leaves the scene's pieces valid, proved in integers; does nothing when they already are.  On an error the pieces are
// where they were.
// Errors: kMarkerOverlaps, kOutsideStrip (deeper than the limit: names the pieces and the depth), kHealingFailed,
// kStoppedEarly.
[[nodiscard]] Result<Repair> repair_overlaps(scene::Scene& scene, const scene::Run& run);

}  // namespace selvage::motion::repair
