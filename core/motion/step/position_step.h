// One round of any motion of many pieces at once: model, solve, round, prove [Li94 4.1.4].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/lp/solver/solve.h"
#include "core/model/active_set.h"
#include "core/model/free_region.h"
#include "core/model/pair_rows.h"
#include "core/motion/step/tuning.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::step {

// A piece that moves no farther than this displacement on either axis, and not the other way.
struct Halt {
  std::uint32_t piece{};
  RealVec at;  // lattice units
};

// What a motion maximises: the sum of force . displacement over all pieces, plus `shorten` times the decrease of the
// marker's length, minus the displacement penalty.  With shorten 0 the length is fixed [Li94 4.2.2].
struct Goal {
  std::vector<RealVec> force;  // one per piece
  double shorten{};
  // The cost of a unit of |dx| or |dy| of any piece: small, so that only pieces that are in the way move.
  double displacement_penalty{};
  std::optional<Halt> halt{};

  [[nodiscard]] bool fixes_length() const { return shorten == 0; }
};
// The goal of leftward compaction [Li94 4.2.1], with a little gravity so that no piece is left free.
[[nodiscard]] Goal leftward_goal(const scene::Scene& scene, double gravity);

struct StepSettings {
  // The trust radius, a fraction of the strip's width.  Near pairs are those within it; a first program has the rows
  // that two near pieces can break while each of them moves by at most the radius on an axis.  At fixed length no pair
  // moves farther than that; otherwise it may, and the rows that it then breaks enter.
  double trust{};
  model::RegionRule region{};
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kActiveSet};
  // A fraction of the width: the tolerance with which the outlines of pieces that are apart are simplified
  // (obstacles.h).
  double simplification{};
  // Each piece's motion in the round before; empty in the first.  Where the marker is shortened, fewer rows of pairs
  // that hardly moved against each other enter at first.
  std::vector<Vec> last_moves{};
  // The tolerance of programs that shorten the marker (core/lp/solver/solve.h).  Those at fixed length are solved as
  // exactly as possible: their dual values tell which pieces are pressed on.
  double tolerance{};
  // A fraction of the width.  A program that shortens the marker, gains less than this and breaks rows that were left
  // out is not solved again: its moves are scaled down until they keep the rows.
  double worth{};
  StepTuning tuning{};
};

enum class StepEnd {
  kMoved,         // `positions` holds the step
  kNoGain,        // nothing more to gain than rounding
  kStopped,       // cancelled
  kSolverFailed,  // no solver could solve the program
};

struct PositionStep {
  StepEnd end{StepEnd::kNoGain};
  std::vector<Vec> positions;           // one per piece: proved valid, the goal better served, the marker no longer
  double gain{};                        // of the goal, in widths of the strip
  int programs{};                       // linear programs solved
  double farthest{};                    // the most that two near pieces moved against each other on an axis, in widths
  std::vector<model::PairRow> pressed;  // the rows that the last program presses on; only where it shortens the marker
};

// The best step towards the goal.  Pairs farther apart than the trust radius are modelled when a solution makes them
// collide; where the goal fixes the length and penalises displacements, pieces are modelled when they are active
// (core/model/active_set.h).
// REQUIRES: the scene's pieces are valid.
[[nodiscard]] PositionStep position_step(const scene::Scene& scene, const Goal& goal, const StepSettings& settings,
                                         const scene::Run& run);

}  // namespace selvage::motion::step
