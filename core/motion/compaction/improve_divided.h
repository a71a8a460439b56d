// Rounds of the whole marker and, where it has many pieces, of its sections (core/motion/sections).
//
//     rounds of the whole marker, up to the first that is hard (none, where some sections foretell that it would be)
//     then: passes over sections, until they gain little
//           rounds of the whole marker
//
// A round is hard when its program has to be solved several times, because its solutions break rows that were left out.
// In a long marker that happens somewhere in nearly every round; a hard first round of a very long one may move
// nothing.  A section solves its program again only when something breaks in that section.
#pragma once

#include "core/motion/compaction/compact.h"

namespace selvage::motion::compaction {

// Rounds are counted and reported in one series; a pass over the sections is a round.  Without
// CompactionSettings::sections, with fewer pieces than the tuning names, and where a marker cannot be divided
// (section_scene.h), these are the rounds of `improve`.  REQUIRES: as `improve`.
[[nodiscard]] Progress improve_divided(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                                       const scene::Run& run);

}  // namespace selvage::motion::compaction
