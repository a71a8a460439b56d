// One round of a repair: the linear program that separates all conflicts, keeps all other near pairs apart and brings
// pieces back into the strip, with the least motion [Li94 5.2].
#pragma once

#include <vector>

#include "core/motion/repair/faults.h"
#include "core/motion/repair/tuning.h"

namespace selvage::motion::repair {

// Moves the scene's pieces to the program's solution, rounded; what rounding breaks is left to another round.  The
// marker grows only when there is no room within its length.  False, with the pieces where they were, when there is no
// room beyond it either, or when cancelled.
// REQUIRES: `conflicts` are the scene's, sorted; no conflict is deeper than `limit` (lattice units).
bool repair_step(scene::Scene& scene, const std::vector<Conflict>& conflicts, double limit, const RepairTuning& tuning,
                 const scene::Run& run);

}  // namespace selvage::motion::repair
