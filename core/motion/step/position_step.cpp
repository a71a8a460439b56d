#include "core/motion/step/position_step.h"

#include "core/marker/clearance.h"
#include "core/motion/step/prove_step.h"
#include "core/motion/step/round_model.h"

namespace selvage::motion::step {
namespace {

// What the goal gains when the pieces move, after rounding; lattice units.
double gain_of(const Goal& goal, const marker::PlacedPieces& before, const marker::PlacedPieces& after) {
  double sum = goal.shorten * static_cast<double>(before.length() - after.length());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec by = after.at(i) - before.at(i);
    sum += goal.force[i].x * static_cast<double>(by.x) + goal.force[i].y * static_cast<double>(by.y);
  }
  return sum;
}

// The step ends with the proved positions when they are in the strip and serve the goal better.
void finish(const scene::Scene& scene, const Goal& goal, const RoundModel& model, const ProvedStep& proved,
            PositionStep& step) {
  const marker::PlacedPieces& moved = *proved.moved;
  if (moved.length() > scene.pieces.length() || !are_inside(moved, scene.marker.strip)) return;
  const double gain = gain_of(goal, scene.pieces, moved);
  if (gain <= 0) return;
  const auto width = static_cast<double>(scene.marker.strip.width);
  step.end = StepEnd::kMoved;
  step.positions = moved.positions();
  step.gain = gain / width;
  step.farthest = farthest_relative(model.near_pairs(), proved.displacements) / width;
}

}  // namespace

Goal leftward_goal(const scene::Scene& scene, double gravity) {
  const auto count = static_cast<double>(scene.pieces.size());
  return {std::vector<RealVec>(scene.pieces.size(), {-gravity / count, 0}), 1, 0};
}

PositionStep position_step(const scene::Scene& scene, const Goal& goal, const StepSettings& settings,
                           const scene::Run& run) {
  const StepTuning& tuning = settings.tuning;
  RoundModel model{scene, goal, settings, run};
  PositionStep step;
  const auto ended = [&step](StepEnd end) {
    step.end = end;
    return step;
  };
  for (bool last = false; !last;) {
    if (run.stopped()) return ended(StepEnd::kStopped);
    const lp::LpSolution solution = model.solve();
    step.programs = model.programs();
    last = step.programs >= tuning.programs || model.has_outgrown();
    if (solution.status == lp::LpStatus::kStopped) return ended(StepEnd::kStopped);
    if (solution.status != lp::LpStatus::kOptimal && model.make_feasible()) continue;
    if (solution.status != lp::LpStatus::kOptimal) return ended(StepEnd::kSolverFailed);

    run.observer.on_stage(scene::Stage::kVerify);
    const double gain = -solution.objective;
    const bool gains = gain >= tuning.least_gain;
    Moves moves = model.moves(solution);
    if (last) {
      model.shorten(moves);
    } else {
      const bool rows_added = gains && model.add_broken_rows(moves, gain);
      const bool pieces_added = model.add_pressed_pieces(solution);
      if (rows_added || pieces_added) {
        model.solve_locally(solution);
        continue;
      }
    }
    if (!goal.fixes_length()) step.pressed = model.pressed_rows(solution);
    if (!gains) return ended(StepEnd::kNoGain);

    ProvedStep proved =
        prove_step(scene.pieces, moves.displacements, model.modelled(), tuning.fractions, *run.executor);
    if (last && !proved.moved) {
      proved = halve_until_valid(scene.pieces, moves.displacements, tuning.halvings, *run.executor);
    }
    if (proved.moved) {
      finish(scene, goal, model, proved, step);
      return step;
    }
    if (step.programs >= tuning.flights_after && model.limit_flights(moves)) {
      model.solve_locally(solution);
      continue;
    }
    const bool foresees = step.programs >= tuning.foresight_after;
    if ((foresees && model.add_pairs(model.ahead_of(moves, proved.conflicts))) || model.add_pairs(proved.conflicts)) {
      model.solve_locally(solution);
    } else {
      model.tie(proved.conflicts);
    }
  }
  return step;
}

}  // namespace selvage::motion::step
