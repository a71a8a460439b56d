#include "core/motion/compaction/escape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/marker/figures.h"
#include "core/motion/closing/close_gaps.h"
#include "core/motion/compaction/sweep.h"
#include "core/motion/sections/section_scene.h"
#include "core/motion/sections/shorten_in_sections.h"

namespace selvage::motion::compaction {
namespace {

// Adds the outcome of later rounds.
void add(const Progress& more, Progress& progress) {
  progress.reason = more.reason;
  progress.rounds += more.rounds;
  progress.programs += more.programs;
  progress.gain += more.gain;
  progress.firm = more.firm;
}

class Escape {
 public:
  Escape(const step::Goal& goal, const CompactionSettings& settings, const scene::Run& run)
      : goal_{goal}, settings_{settings}, run_{run}, quiet_{run.quiet()} {}

  // Sweeps and rounds in turn while they gain.
  void take_turns(scene::Scene& scene, Progress& progress) const {
    for (Coord before = kLatticeLimit; is_worth(before, scene.pieces.length()) && may_go_on(progress);) {
      before = scene.pieces.length();
      sweep_and_round(scene, progress);
    }
  }
  // The same, unless sweeps alone leave the marker longer than `length`; then they do not count as a round.
  void take_turns_if_shorter(Coord length, scene::Scene& scene, Progress& progress) const {
    int sweeps = 0;
    if (sweep_until_still(scene, {.sweeps = settings_.tuning.sweeps}, quiet_, sweeps) ==
        scene::StopReason::kCancelled) {
      progress.reason = scene::StopReason::kCancelled;
    } else if (scene.pieces.length() < length) {
      take_turns(scene, progress);
    }
  }
  // Sweeps until nothing moves, which count as one round, then rounds.
  void sweep_and_round(scene::Scene& scene, Progress& progress) const {
    int sweeps = 0;
    if (sweep_until_still(scene, {.sweeps = settings_.tuning.sweeps}, quiet_, sweeps) ==
        scene::StopReason::kCancelled) {
      progress.reason = scene::StopReason::kCancelled;
      return;
    }
    CompactionSettings rest = settings_;
    rest.rounds = settings_.rounds - ++progress.rounds;
    add(improve(scene, goal_, rest, quiet_), progress);
    run_.observer.on_round({progress.rounds, scene.pieces.length()});
  }
  [[nodiscard]] bool may_go_on(const Progress& progress) const {
    return progress.reason != scene::StopReason::kCancelled && progress.rounds < settings_.rounds;
  }
  [[nodiscard]] bool is_worth(Coord before, Coord after) const {
    return static_cast<double>(before - after) > settings_.tuning.worth_a_sweep * static_cast<double>(before);
  }

 private:
  const step::Goal& goal_;
  const CompactionSettings& settings_;
  const scene::Run& run_;
  const scene::Run quiet_;  // reports nothing: a turn is reported as one round, when it has ended
};

bool nothing_moves(const scene::Scene& scene) {
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    if (!scene.fixed(k)) return false;
  }
  return true;
}

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

// Rounds of the whole marker.  A marker of many pieces is shortened in sections from its first hard round on, before
// further rounds of the whole.
Progress improve_all(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
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
  add(improve_sections(scene, rest, later), progress);
  rest.rounds = settings.rounds - progress.rounds;
  add(improve(scene, goal, rest, later), progress);
  return progress;
}

}  // namespace

Progress shorten(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                 const scene::Run& run) {
  const Escape escape{goal, settings, run};
  if (settings.rounds > 0) {
    const double near = first_trust(scene, settings) * static_cast<double>(scene.marker.strip.width);
    closing::close_gaps(scene, std::llround(near), settings.tuning.many_loose, run);
  }
  const std::vector<Vec> start = scene.pieces.positions();
  const Coord start_length = scene.pieces.length();
  Progress progress = improve_all(scene, goal, settings, run);
  if (!settings.sweeps || scene.pieces.size() > settings.tuning.most_pieces_swept || !escape.may_go_on(progress) ||
      nothing_moves(scene)) {
    return progress;
  }
  const double used = marker::utilisation_at(scene.marker, scene.pieces.length());
  const bool loose = used < settings.tuning.loose_below;
  const bool stuck = !progress.firm && !escape.is_worth(start_length, scene.pieces.length());
  if (loose || stuck) escape.take_turns(scene, progress);
  if (!escape.may_go_on(progress) || !(loose || scene.pieces.size() <= kFewPieces)) return progress;
  const std::vector<Vec> reached = scene.pieces.positions();
  const Coord length = scene.pieces.length();
  scene.pieces.place(start);
  Progress other = progress;
  const scene::Run quiet = run.quiet();  // rounds that are longer than those reported before are not reported
  const Escape again{goal, settings, quiet};
  if (loose) {
    again.take_turns(scene, other);
  } else {
    again.take_turns_if_shorter(length, scene, other);
  }
  if (scene.pieces.length() >= length) {
    scene.pieces.place(reached);
    other.gain = progress.gain;
  } else {
    run.observer.on_round({other.rounds, scene.pieces.length()});
  }
  return other;
}

}  // namespace selvage::motion::compaction
