// One round of any motion of many pieces at once: model, solve, snap, prove [Li94 4.1.4].
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/lp/solver/solve.h"
#include "core/model/active_set.h"
#include "core/model/free_region.h"
#include "core/model/position_model.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::step {

// A piece that goes no farther than this on either axis, and not back.
struct Halt {
  std::uint32_t piece{};
  RealVec at;
};

// What a motion wants: as much as possible of the sum of force . displacement over all pieces, plus `shorten` times
// what the marker gets shorter.  With shorten 0 its length is held [Li94 4.2.2].
struct Goal {
  std::vector<RealVec> force;  // one per piece
  double shorten{};
  double
      displacement_penalty{};  // what a unit of any piece's motion costs: small, so that only what is in the way moves
  std::optional<Halt> halt{};
};
// The goal of leftward compaction [Li94 4.2.1], with a little gravity so that no piece is left free.
[[nodiscard]] Goal leftward_goal(const scene::Scene& scene, double gravity);

struct StepSettings {
  double trust{};  // neighbours are pairs within this part of the width; of their rows those enter at once that moving
                   // apart or together by twice that can break.  With the length held no two of them move by more;
                   // otherwise they may, and the rows which that breaks enter then
  model::RegionRule region{};
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kReached};
  double simplification{};  // of outlines that are apart, as a part of the width (obstacles.h)
  // Of each piece, in the round before; none in the first.  Where the marker is made shorter, of pairs that hardly
  // moved against each other then, fewer rows enter at once.
  std::vector<Vec> last_moves{};
  double tolerance{};  // of programs that shorten the marker (core/lp/solve.h); with the length held they are solved as
                       // well as can be, for what presses on what is read from their prices
  double worth{};  // a program that shortens the marker, gains less than this part of the width and breaks rows that
                   // were left out is not solved again: its moves are shortened until they keep them
};

enum class StepEnd {
  kMoved,         // `positions` holds the step
  kNoGain,        // nothing more to gain than rounding
  kStopped,       // asked to stop
  kSolverFailed,  // no solver could solve the program
};

struct PositionStep {
  StepEnd end{StepEnd::kNoGain};
  std::vector<Vec> positions;  // one per piece: proved valid, the goal better served, the marker no longer
  double gain{};               // of the goal, as a part of the strip's width
  int programs{};              // linear programs solved
  double farthest{};  // the most that two near pieces moved against each other on an axis, as a part of the width
};

// The best step towards the goal.  Pairs farther apart than the trust are only modelled when a solution makes them
// collide; of a goal with stillness that holds the length, pieces only when they are reached (core/model/reached.h).
// REQUIRES: the scene's pieces are valid.
[[nodiscard]] PositionStep position_step(const scene::Scene& scene, const Goal& goal, const StepSettings& settings,
                                         const scene::Run& run);

}  // namespace selvage::motion::step
