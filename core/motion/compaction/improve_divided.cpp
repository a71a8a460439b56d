#include "core/motion/compaction/improve_divided.h"

#include <algorithm>

#include "core/motion/sections/section_scene.h"
#include "core/motion/sections/shorten_in_sections.h"

namespace selvage::motion::compaction {
namespace {

// Rounds of a section, as many as the settings allow.
sections::ShortenSection section_rounds(CompactionSettings settings) {
  settings.least_gain = std::max(settings.least_gain, settings.tuning.section_gain);
  settings.sweeps = false;
  return [settings](scene::Scene& section, const scene::Run& run) -> sections::SectionGain {
    const Progress progress = improve(section, step::leftward_goal(section, settings.gravity), settings, run);
    return {progress.gain, progress.programs};
  };
}

// Whether the first round of a marker of many sections is going to be hard: the section in the middle, and another one,
// solve their programs more than once in a round of their own.
bool begins_hard(const scene::Scene& scene, const CompactionSettings& settings, const scene::Run& run) {
  if (settings.rounds == 0 || scene.pieces.size() < settings.tuning.sections.sampled) return false;
  CompactionSettings once = settings;
  once.rounds = 1;
  const auto is_hard = [&](double at) {
    return sections::shorten_copy(scene, settings.tuning.sections, at, section_rounds(once), run).programs > 1;
  };
  return is_hard(0.5) && (is_hard(0.25) || is_hard(0.75));
}

// Shortens the scene in sections.  Each pass counts as a round.
Progress improve_sections(scene::Scene& scene, const CompactionSettings& settings, const scene::Run& run) {
  const Coord before = scene.pieces.length();
  const sections::Passes done =
      sections::shorten_in_sections(scene, settings.tuning.sections, settings.rounds, section_rounds(settings), run);
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
  Progress progress;
  if (!divides || !begins_hard(scene, settings, run)) {
    progress = improve(scene, goal, first, run);
    if (!progress.hard) return progress;
  }
  scene::Run later = run;
  later.observer.on_round = [&](scene::Round round) {
    round.number += progress.rounds;
    run.observer.on_round(round);
  };
  CompactionSettings rest = settings;
  rest.rounds = settings.rounds - progress.rounds;
  progress += improve_sections(scene, rest, later);
  rest.rounds = settings.rounds - progress.rounds;
  rest.least_gain = tuning.later_gain * settings.least_gain;
  progress += improve(scene, goal, rest, later);
  return progress;
}

}  // namespace selvage::motion::compaction
