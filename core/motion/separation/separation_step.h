// One round of separation: the linear program that separates overlapping pieces with the least motion [Li94 5.2], with
// rows that may be violated at a price [Li94 7.9], so that it is always feasible.  It has columns for the pieces that
// overlap, are away from where they are wanted or beyond the length, and for those that these press on
// (core/model/active_set.h).
#pragma once

#include <stop_token>
#include <vector>

#include "core/lp/solver/solve.h"
#include "core/model/active_set.h"
#include "core/motion/repair/separation_target.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::separation {

// A pair that overlaps or is too close, and the boundary point to separate it at.
struct OverlappingPair {
  marker::PiecePair pair;
  repair::SeparationTarget target;
  double price{};  // of a unit of overlap that stays, relative to a piece moving by a unit
};

// What the length may become, and at what price, relative to a piece moving by as much.
struct LengthAllowance {
  Coord free{};     // up to this length there is no price
  Coord allowed{};  // up to this length `price`, beyond it `excess_price`
  double price{};
  double excess_price{};
};

struct SeparationStepSettings {
  double reach{};  // lattice units: pairs and rows within this distance are modelled
  double price{};  // of rows of pairs that do not overlap but have no room for their margins
  model::TightRows tight{model::TightRows::kKeep};  // whether those rows are to regain their margins
  LengthAllowance length;
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kActiveSet};  // kWhole: of all pieces; pairs and rows as the reach says
  double tolerance{};                               // of the solver (core/lp/solver/solve.h)
};

struct SeparationStep {
  lp::LpStatus status{};
  int programs{};                // linear programs solved
  std::vector<Vec> positions;    // one per piece, rounded; inside the strip's width; not proved
  std::vector<double> pressure;  // of each piece: the sum of the dual values of its rows
};

// `overlapping` sorted by pair.  `home[i]`: where piece i is wanted; the motion counted is the distance from there.
// REQUIRES: the pieces lie within the strip's width and right of its start.
[[nodiscard]] SeparationStep separation_step(const scene::Scene& scene, const std::vector<OverlappingPair>& overlapping,
                                             const std::vector<Vec>& home, const SeparationStepSettings& settings,
                                             const scene::Run& run);

}  // namespace selvage::motion::separation
