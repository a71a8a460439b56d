#include "core/motion/compaction/escape.h"

#include <cmath>

#include "core/marker/figures.h"
#include "core/motion/closing/close_gaps.h"
#include "core/motion/compaction/improve_divided.h"
#include "core/motion/piece/sweep.h"

namespace selvage::motion::compaction {
namespace {

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
    if (piece::sweep_until_still(scene, {.sweeps = settings_.tuning.sweeps}, quiet_, sweeps) ==
        scene::StopReason::kCancelled) {
      progress.reason = scene::StopReason::kCancelled;
    } else if (scene.pieces.length() < length) {
      take_turns(scene, progress);
    }
  }
  // Sweeps until nothing moves, which count as one round, then rounds.
  void sweep_and_round(scene::Scene& scene, Progress& progress) const {
    int sweeps = 0;
    if (piece::sweep_until_still(scene, {.sweeps = settings_.tuning.sweeps}, quiet_, sweeps) ==
        scene::StopReason::kCancelled) {
      progress.reason = scene::StopReason::kCancelled;
      return;
    }
    CompactionSettings rest = settings_;
    rest.rounds = settings_.rounds - ++progress.rounds;
    progress += improve(scene, goal_, rest, quiet_);
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

bool is_loose(const scene::Scene& scene, const CompactionSettings& settings) {
  return marker::utilisation_at(scene.marker, scene.pieces.length()) < settings.tuning.loose_below;
}

bool nothing_moves(const scene::Scene& scene) {
  for (std::size_t k = 0; k < scene.pieces.size(); ++k) {
    if (!scene.fixed(k)) return false;
  }
  return true;
}

// Rounds and sweeps as escape.h describes them, once.
Progress shorten_once(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                      const scene::Run& run) {
  const Escape escape{goal, settings, run};
  if (settings.rounds > 0) {
    const double near = first_trust(scene, settings) * static_cast<double>(scene.marker.strip.width);
    closing::close_gaps(scene, std::llround(near), settings.tuning.many_loose, run);
  }
  const std::vector<Vec> start = scene.pieces.positions();
  const Coord start_length = scene.pieces.length();
  Progress progress = improve_divided(scene, goal, settings, run);
  if (!settings.sweeps || scene.pieces.size() > settings.tuning.most_pieces_swept || !escape.may_go_on(progress) ||
      nothing_moves(scene)) {
    return progress;
  }
  const bool loose = is_loose(scene, settings);
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

bool may_repeat(const scene::Scene& scene, const CompactionSettings& settings) {
  return scene.pieces.size() <= kFewPieces ||
         (scene.pieces.size() <= settings.tuning.most_pieces_repeated && is_loose(scene, settings));
}

// Each time starts from where the last one has left the pieces, even if that gained nothing: the way may lead through
// places from which a later one gains.
void repeat(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings, const scene::Run& run,
            Progress& progress) {
  const scene::Run quiet = run.quiet();
  const Escape escape{goal, settings, quiet};
  std::vector<Vec> reached = scene.pieces.positions();
  Coord length = scene.pieces.length();
  bool moved = true;
  for (int in_vain = 0; in_vain < settings.tuning.repeated_in_vain && moved && escape.may_go_on(progress);) {
    const std::vector<Vec> before = scene.pieces.positions();
    CompactionSettings rest = settings;
    rest.rounds = settings.rounds - progress.rounds;
    const Progress again = shorten_once(scene, goal, rest, quiet);
    moved = scene.pieces.positions() != before;
    if (escape.is_worth(length, scene.pieces.length())) {
      in_vain = 0;
      reached = scene.pieces.positions();
      length = scene.pieces.length();
      progress += again;
      run.observer.on_round({progress.rounds, length});
    } else {
      ++in_vain;
      progress.programs += again.programs;
      if (run.stopped()) progress.reason = scene::StopReason::kCancelled;
    }
  }
  scene.pieces.place(reached);
}

}  // namespace

Progress shorten(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                 const scene::Run& run) {
  const std::vector<Vec> start = scene.pieces.positions();
  Progress progress = shorten_once(scene, goal, settings, run);
  const bool moved = scene.pieces.positions() != start;
  if (settings.sweeps && moved && may_repeat(scene, settings)) repeat(scene, goal, settings, run, progress);
  return progress;
}

}  // namespace selvage::motion::compaction
