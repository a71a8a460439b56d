// One round of tilting by linearisation [Li94 6.2.4]: all pieces move and turn at once, as one linear program says. The
// result is not proved: turns are linearised, so pieces may overlap a little afterwards.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/lp/solver/solve.h"
#include "core/model/tilting/tilt_model.h"
#include "core/motion/step/position_step.h"
#include "core/motion/tilting/tuning.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::tilting {

struct TiltStepSettings {
  Angle turn;      // no piece turns farther
  double trust{};  // no pivot moves farther on an axis than this part of the strip's width
  lp::solver::SolverChoice solver{};
  TiltStepTuning tuning{};
};

struct TiltStep {
  lp::LpStatus status{};
  std::vector<Piece> pieces;  // the scene's, moved and tilted; within their limits to the last bit
};

// `torque[i]`: the value of a unit of arc of piece i's farthest vertex, counter-clockwise, relative to the goal's
// forces; an empty span means no torques.
[[nodiscard]] TiltStep tilt_step(const scene::Scene& scene, const step::Goal& goal, std::span<const double> torque,
                                 const TiltStepSettings& settings, const scene::Run& run);

}  // namespace selvage::motion::tilting
