// The interior point method: for models of more than a few hundred rows.
//
// Mehrotra's predictor and corrector on the normal equations, with the proximal terms of [PG21] on both sides: rho
// keeps columns that nothing holds (free, zero cost) from making the matrix singular, delta bounds the weight of rows
// without an interior.  Needs no feasible start; begins at x = 0 moved into the column bounds, which in position models
// is the present layout and nearly feasible.
// Sources: [Meh92], [PG21].  Departs: inequality form, so the matrix has one row per column of the program.
#pragma once

#include <stop_token>

#include "core/lp/linear_program.h"

namespace selvage::lp::interior_point {

struct InteriorPointSettings {
  int iterations{120};        // factorisations; few need more than 60
  double gap{1e-10};          // complementarity over 1 + |objective|
  double primal{1e-11};       // the most a row of the answer may be broken by, but for the rounding of its bound
  double dual{1e-10};         // the same for the dual, over 1 + the largest cost
  double dual_at_rest{1e-8};  // good enough once rounding keeps it from falling further
};

// Settings for an answer that is worse than the best by at most `tolerance` (of 1 + |objective|), or as little as by
// the settings above when that is more.  Its rows hold as solve() asks; in exchange for the tolerance it is reached
// sooner.
[[nodiscard]] InteriorPointSettings settled_within(double tolerance);

// The answer lies inside the feasible region, in the middle of the optimal face.  kFailed when it does not get there:
// no proof of infeasibility or unboundedness is attempted, ask the simplex method.  Deterministic; looks at `stop` once
// per iteration.
// REQUIRES: lower <= upper, no NaN.
[[nodiscard]] LpSolution solve_by_interior_point(const LinearProgram& program,
                                                 const InteriorPointSettings& settings = {}, std::stop_token stop = {});

}  // namespace selvage::lp::interior_point
