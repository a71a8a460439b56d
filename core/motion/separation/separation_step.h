// One round of separation: the linear program that parts overlapping pieces with the least motion [Li94 5.2], with rows
// that may be broken at a price [Li94 7.9], so that it always has an answer.  It has columns for the pieces that
// overlap, are away from home or beyond the length, and for those that these press upon (core/model/reached.h).
#pragma once

#include <stop_token>
#include <vector>

#include "core/lp/solver/solve.h"
#include "core/model/active_set.h"
#include "core/motion/repair/separation_target.h"
#include "core/scene/run.h"
#include "core/scene/scene.h"

namespace selvage::motion::separation {

// A pair that overlaps or is too close, and where it is to part.
struct PartingPair {
  marker::PiecePair pair;
  repair::SeparationTarget target;
  double price{};  // of a unit of overlap that stays, beside a piece moving by a unit
};

// What the length may become, and at what price beside a piece moving by as much.
struct LengthAllowance {
  Coord free{};     // up to here nothing is paid
  Coord allowed{};  // up to here `price`, beyond `excess_price`
  double price{};
  double excess_price{};
};

struct PartingSettings {
  double reach{};  // pairs and rows within so many lattice units are modelled
  double price{};  // for rows of pairs that do not overlap and have no room for their margins
  LengthAllowance length;
  lp::solver::SolverChoice solver{};
  model::Extent extent{model::Extent::kReached};  // kWhole: of all pieces; pairs and rows as the reach says
};

struct SeparationStep {
  lp::LpStatus status{};
  int programs{};                // linear programs solved
  std::vector<Vec> positions;    // one per piece, rounded; inside the strip's width; not proved
  std::vector<double> pressure;  // of each piece: the sum of the dual values of its rows
};

// `parting` sorted by pair.  `home[i]`: where piece i is wanted; the motion counted is the distance from there.
// REQUIRES: the pieces lie within the strip's width and right of its start.
[[nodiscard]] SeparationStep separation_step(const scene::Scene& scene, const std::vector<PartingPair>& parting,
                                             const std::vector<Vec>& home, const PartingSettings& settings,
                                             const scene::Run& run);

}  // namespace selvage::motion::separation
