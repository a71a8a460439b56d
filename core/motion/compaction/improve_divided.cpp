#include "core/motion/compaction/improve_divided.h"

#include <algorithm>

#include "core/motion/sections/section_scene.h"
#include "core/motion/sections/shorten_in_sections.h"

namespace selvage::motion::compaction {
namespace {

// Shortens the scene in sections.  Each pass counts as a round.
Progress improve_sections(scene::Scene& scene, const CompactionSettings& settings, const scene::Run& run) {
  CompactionSettings of_section = settings;
  of_section.least_gain = std::max(settings.least_gain, settings.tuning.section_gain);
  of_section.sweeps = false;
  const auto shorten_section = [&](scene::Scene& section, const scene::Run& own) -> sections::SectionGain {
    const Progress progress = improve(section, step::leftward_goal(section, settings.gravity), of_section, own);
    return {progress.gain, progress.programs};
  };
  const Coord before = scene.pieces.length();
  const sections::Passes done =
      sections::shorten_in_sections(scene, settings.tuning.sections, settings.rounds, shorten_section, run);
  Progress progress;
  progress.rounds = done.passes;
  progress.programs = done.programs;
  progress.gain = static_cast<double>(before - scene.pieces.length());
  return progress;
}

}  // namespace

Progress improve_divided(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                         const scene::Run& run) {
  const CompactionTuning& tuning = settings.tuning;
  const bool divides =
      settings.sections && scene.pieces.size() >= tuning.sections.many && sections::can_be_divided(scene);
  CompactionSettings first = settings;
  first.hard_round = divides ? tuning.hard_round : 0;
  Progress progress = improve(scene, goal, first, run);
  if (!progress.hard) return progress;
  scene::Run later = run;
  later.observer.on_round = [&](scene::Round round) {
    round.number += progress.rounds;
    run.observer.on_round(round);
  };
  CompactionSettings rest = settings;
  rest.rounds = settings.rounds - progress.rounds;
  progress += improve_sections(scene, rest, later);
  rest.rounds = settings.rounds - progress.rounds;
  progress += improve(scene, goal, rest, later);
  return progress;
}

}  // namespace selvage::motion::compaction
