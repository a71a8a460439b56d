// One round of floating: model, solve, snap, prove.
#pragma once

#include <stop_token>

#include "core/lp/solver/solve.h"
#include "core/motion/floating/float_program.h"
#include "core/motion/step/position_step.h"
#include "core/scene/run.h"

namespace selvage::motion::floating {

struct FloatStep {
  step::StepEnd end{step::StepEnd::kNoGain};
  std::vector<Vec> positions;  // when kMoved: proved valid, no gap narrower than its `least`, the worth greater
  double gain{};               // of the worth, lattice units
  double farthest{};           // the most that a piece moved on an axis, lattice units
  int programs{};
  std::vector<double> loads;  // of each gap, in the first program; empty when that was not solved
};

// No piece moves farther than `trust` (lattice units) on either axis.
// REQUIRES: the scene's pieces are valid; `gaps` contains every gap that may be narrower than the aim's `most` plus
// twice the trust radius.
[[nodiscard]] FloatStep float_step(const scene::Scene& scene, const FloatAim& aim, std::span<const FloatGap> gaps,
                                   double trust, lp::solver::SolverChoice solver, const scene::Run& run);

}  // namespace selvage::motion::floating
