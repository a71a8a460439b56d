// The scene of a section: a marker of its own, made of its pieces and of the layers beside it.
#pragma once

#include <vector>

#include "core/motion/sections/sections.h"
#include "core/scene/scene.h"

namespace selvage::motion::sections {

// True when every piece of the marker moves on its own and lies where it likes, so that sections know all that holds
// them: none is locked, belongs to a group or has rules (core/marker/rules.h).
[[nodiscard]] bool can_be_divided(const scene::Scene& scene);

struct SectionScene {
  scene::Scene scene;  // the section's free pieces, then those of its left layer, then those of its right one
  Vec origin;          // of its strip, in the whole marker; lattice units
};
// The left layer is fixed.  The right one moves along the strip as one body, and not across.
// REQUIRES: can_be_divided(whole).
[[nodiscard]] SectionScene scene_of(const Section& section, const scene::Scene& whole, const scene::Run& run);

// The result of shortening a section.
struct MovedSection {
  std::vector<Vec> positions;  // of its free pieces in the whole marker, as if its left layer had not moved
  Coord shift{};               // by which its right layer moved along the strip; 0 when there is none
};
[[nodiscard]] MovedSection moved_section(const Section& section, const SectionScene& done, const scene::Scene& whole);

}  // namespace selvage::motion::sections
