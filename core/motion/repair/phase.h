// Match sets brought into phase (core/marker/rules.h): every piece moves to the nearest repeat of its set.
#pragma once

#include "core/scene/scene.h"

namespace selvage::motion::repair {

// The most by which a piece is off the phase of its match set; lattice units.
[[nodiscard]] Coord off_phase(const scene::Scene& scene);

// Moves the pieces of each match set, and what is tied to them, into the phase of one of them that cannot move, or of
// the first.  Other rules and overlaps are ignored.  A piece that cannot move stays.
void into_phase(scene::Scene& scene);

}  // namespace selvage::motion::repair
