#include "core/motion/compaction/compact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/marker/figures.h"
#include "core/model/contacts/contact.h"
#include "core/motion/compaction/escape.h"
#include "core/motion/step/position_step.h"
#include "core/scene/scene.h"

namespace selvage::motion::compaction {
namespace {

scene::StopReason reason_of(step::StepEnd end) {
  return end == step::StepEnd::kSolverFailed ? scene::StopReason::kSolverFailed : scene::StopReason::kConverged;
}

// True when every row that the last program pressed on is a contact that no other half-plane would lift.
bool are_firm(const scene::Scene& scene, const std::vector<model::PairRow>& pressed, double tolerance) {
  return std::all_of(pressed.begin(), pressed.end(), [&](const model::PairRow& row) {
    const minkowski::Obstacle obstacle = scene.obstacle(row.pair);
    const Vec r = scene.relative_position(row.pair);
    return model::contacts::backing_of(row, {obstacle, r, r, scene.pieces.spacing(row.pair)}, tolerance) ==
           model::contacts::Backing::kEdge;
  });
}

}  // namespace

// Figures behind these choices: docs/measurements/README.md.
CompactionSettings compaction_settings(Accuracy accuracy) {
  switch (accuracy) {
    case Accuracy::kDraft:
      return {.rounds = 2,
              .least_gain = 0.05,
              .trust = 0.1,
              .gravity = 0.003,
              .region = model::RegionRule::kGreedy,
              .solver = lp::solver::SolverChoice::kAutomatic,
              .solver_tolerance = 1e-4};
    case Accuracy::kStandard:
      return {.rounds = 400,
              .least_gain = 2e-5,
              .trust = 0.1,
              .gravity = 0.003,
              .sections = true,
              .sweeps = true,
              .region = model::RegionRule::kGreedy,
              .solver = lp::solver::SolverChoice::kAutomatic,
              .solver_tolerance = 1e-4};
    case Accuracy::kFine: break;
  }
  CompactionSettings fine{.rounds = 400,
                          .least_gain = 1e-8,
                          .trust = 0.3,
                          .gravity = 0.003,
                          .sections = true,
                          .sweeps = true,
                          .region = model::RegionRule::kGreedy,
                          .solver = lp::solver::SolverChoice::kAutomatic};
  fine.tuning.most_near_pairs = 32;  // it looks three times as far
  return fine;
}

double first_trust(const scene::Scene& scene, const CompactionSettings& settings) {
  const auto width = static_cast<double>(scene.marker.strip.width);
  const double most = settings.tuning.most_near_pairs * static_cast<double>(scene.pieces.size());
  const auto too_many = [&](double trust) {
    double near = 0;
    const Coord distance = std::llround(trust * width) + scene.pieces.widest_spacing();
    return any_pair_within(scene.pieces, distance, [&](marker::PiecePair) { return ++near > most; });
  };
  double trust = settings.trust;
  while (trust * width > 1 && too_many(trust)) trust /= 2;
  return trust;
}

Progress& Progress::operator+=(const Progress& later) {
  reason = later.reason;
  rounds += later.rounds;
  programs += later.programs;
  gain += later.gain;
  hard = later.hard;
  firm = later.firm;
  return *this;
}

Progress improve(scene::Scene& scene, const step::Goal& goal, const CompactionSettings& settings,
                 const scene::Run& run) {
  Progress progress;
  progress.reason = scene::StopReason::kWorkLimit;
  const double trust = goal.fixes_length() ? settings.trust : first_trust(scene, settings);
  step::StepSettings step_settings{.trust = trust,
                                   .region = settings.region,
                                   .solver = settings.solver,
                                   .extent = settings.extent,
                                   .simplification = settings.simplification,
                                   .tolerance = settings.solver_tolerance,
                                   .tuning = settings.tuning.step};
  // In long markers the gain that justifies another round is measured against the length.
  const double widths = static_cast<double>(scene.pieces.length()) / static_cast<double>(scene.marker.strip.width);
  const double least_gain =
      settings.least_gain * (goal.shorten > 0 ? std::max(1.0, widths / settings.tuning.long_from) : 1.0);
  if (settings.hard_round > 0) step_settings.tuning.programs = settings.hard_round;
  step_settings.worth = std::min(settings.least_gain, settings.tuning.little);
  std::vector<model::PairRow> pressed;
  while (progress.rounds < settings.rounds) {
    step::PositionStep step = position_step(scene, goal, step_settings, run);
    pressed = std::move(step.pressed);
    progress.programs += step.programs;
    progress.hard = settings.hard_round > 0 && step.programs >= settings.hard_round;
    run.observer.on_stage(scene::Stage::kOther);
    if (step.end != step::StepEnd::kMoved || run.stopped()) {
      progress.reason = run.stopped() ? scene::StopReason::kCancelled : reason_of(step.end);
      break;
    }
    step_settings.last_moves.resize(scene.pieces.size());
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
      step_settings.last_moves[i] = step.positions[i] - scene.pieces.at(i);
    }
    scene.pieces.place(step.positions);
    // Pieces move less from round to round: look only as far as the next round may go.  In a shorter marker, more of
    // them may be near.
    const double most = goal.fixes_length() ? trust : std::min(trust, first_trust(scene, settings));
    step_settings.trust =
        std::clamp(settings.tuning.trust_ahead * step.farthest, settings.tuning.least_trust * most, most);
    progress.gain += step.gain * static_cast<double>(scene.marker.strip.width);
    ++progress.rounds;
    run.observer.on_round({progress.rounds, scene.pieces.length()});
    if (step.gain < least_gain) {
      progress.reason = scene::StopReason::kConverged;
      break;
    }
    if (progress.hard) break;
  }
  const double touching = settings.tuning.touching * static_cast<double>(scene.marker.strip.width);
  progress.firm = settings.sweeps && progress.reason != scene::StopReason::kSolverFailed && !run.stopped() &&
                  are_firm(scene, pressed, touching);
  return progress;
}

void record(const Progress& progress, repair::MotionResult& result) {
  result.reason = progress.reason;
  result.rounds = progress.rounds;
  result.programs = progress.programs;
}

Result<Compaction> shortened(const Marker& start, const scene::Run& run,
                             const std::function<Progress(scene::Scene&)>& work) {
  auto done = repair::repaired_and<Compaction>(
      start, run, [&](scene::Scene& scene, Compaction& compaction) { record(work(scene), compaction); });
  if (!done) return done;
  done->utilisation_before = utilisation_at(start, done->length_before);
  done->utilisation_after = utilisation_at(done->marker, done->length_after);
  return done;
}

Result<Compaction> compact(const Marker& start, const CompactionSettings& settings, const scene::Run& run) {
  return shortened(start, run, [&](scene::Scene& scene) {
    return shorten(scene, step::leftward_goal(scene, settings.gravity), settings, run);
  });
}

}  // namespace selvage::motion::compaction
