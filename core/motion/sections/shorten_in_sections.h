// Long markers, shortened in sections.
//
// The program of a round is solved again while its solution breaks rows that were left out or makes far pieces collide
// [Li94 4.1.4].  In a marker of many thousand pieces something of the kind happens somewhere after nearly every
// solution, and each time all of it is solved again.  A section (sections.h) solves only its own program again, and
// several threads work on several sections.  Each pass cuts the marker elsewhere, so that the pieces of the layers move
// in the next one.  Rounds of the whole marker come last, because only they know the whole critical path.
#pragma once

#include <functional>

#include "core/motion/sections/tuning.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::sections {

struct SectionGain {
  double gain{};  // of the goal; lattice units
  int programs{};
};
// Shortens the scene of one section.  Called by several threads at the same time, each time for another scene.
using ShortenSection = std::function<SectionGain(scene::Scene&, const scene::Run&)>;

struct Passes {
  int passes{};
  int programs{};  // of all sections
};

// Passes until one gains too little (SectionTuning), `most` at most.  Each pass is reported as a round.  The pieces
// stay valid, and the marker never becomes longer.  The answer does not depend on the executor.
// REQUIRES: can_be_divided(scene); the scene's pieces are valid.
[[nodiscard]] Passes shorten_in_sections(scene::Scene& scene, const SectionTuning& tuning, int most,
                                         const ShortenSection& shorten, const scene::Run& run);

// What shortening one section would gain; the scene stays as it is.  `at`, 0 <= at < 1: where the section lies, as a
// part of their number.  REQUIRES: can_be_divided(scene).
[[nodiscard]] SectionGain shorten_copy(const scene::Scene& scene, const SectionTuning& tuning, double at,
                                       const ShortenSection& shorten, const scene::Run& run);

}  // namespace selvage::motion::sections
