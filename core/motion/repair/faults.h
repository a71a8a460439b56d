// The faults of a layout, their depths, and the errors that report faults that are not repaired.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/motion/repair/separation_target.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::repair {

// Two pieces that overlap by more than their allowance, or are closer than their spacing.
struct Conflict {
  marker::PiecePair pair;
  SeparationTarget target;
};
// All conflicts, sorted by pair; at most marker::kMostConflicts of them.  When cancelled, only some.
[[nodiscard]] std::vector<Conflict> find_conflicts(const scene::Scene& scene, const scene::Run& run);

// By how much a piece leaves the strip; at least 0; lattice units.
[[nodiscard]] Coord protrusion(const scene::Scene& scene, std::size_t piece);
[[nodiscard]] bool any_protrusion(const scene::Scene& scene);

// Refuses faults that are deeper than the limit, in lattice units, and marker::kMostConflicts conflicts or more.
// Errors: kOutsideStrip, kMarkerOverlaps.
[[nodiscard]] std::optional<Error> refuse_deep(const scene::Scene& scene, const std::vector<Conflict>& conflicts,
                                               double limit);
// The error when no motion repairs the faults.  REQUIRES: the pieces are where they were; there is a fault.
[[nodiscard]] Error repair_failed(const scene::Scene& scene, const std::vector<Conflict>& conflicts);

}  // namespace selvage::motion::repair
