// The interior point method, for models of more than a few hundred rows.
//
// Mehrotra's predictor-corrector method on the normal equations, with the proximal terms of [PG21] on both sides: rho
// keeps unconstrained columns of zero cost from making the matrix singular, and delta bounds the weights of rows
// without an interior.  The start need not be feasible: it is x = 0 clamped to the column bounds, which for position
// models is the present layout and nearly feasible.
// Large programs are divided into domains and a border (division.h); threads of the executor work on the domains, and
// the border's normal equations are what remains of theirs.
// In an infeasible program the prices grow without limit, and their products with the rows prove it after a dozen
// iterations (Farkas' lemma).
// Sources: [Meh92], [PG21].  The method departs from them in using the inequality form, so that the matrix has one row
// per column of the program.
#pragma once

#include <stop_token>

#include "core/base/executor.h"
#include "core/lp/linear_program.h"

namespace selvage::lp::interior_point {

struct InteriorPointSettings {
  int iterations{120};             // largest number of factorisations; few programs need more than 60
  double gap{1e-10};               // complementarity divided by 1 + |objective|
  double primal{1e-11};            // largest violation of a row, apart from the rounding of its bound
  double dual{1e-10};              // largest violation of a dual constraint, divided by 1 + the largest cost
  double dual_when_stalled{1e-8};  // the same, once rounding prevents further progress
  // Solutions with larger columns are of no use.  A program counts as infeasible when its prices prove that every point
  // within reach breaks some row by far more than rounding does.  Infinite: that is not tried.
  double reach{kInfinity};
  // The method fails after this many iterations in a row in which the gap was closed but row violations did not fall.
  int stalls{10};
  // Pieces in a domain (division.h).  Smaller domains share the work among more threads, but leave more of it to the
  // border, which one thread works on.
  int domain_size{500};
};

// The smallest row violation that a solution can guarantee in spite of rounding: a few roundings of the largest finite
// bound, which in position models of long markers is the distance to the strip's start.
[[nodiscard]] double attainable_violation(const LinearProgram& program);

// Settings for a solution whose objective exceeds the optimum by at most `tolerance` (of 1 + |objective|), or by the
// default gap above if that is larger.  A larger tolerance saves iterations.  Rows are still met as accurately as
// solve() requires.
[[nodiscard]] InteriorPointSettings settings_for_tolerance(double tolerance);

// The solution lies in the interior of the feasible region, near the centre of the optimal face.  kInfeasible as the
// settings' reach says.  kFailed when the method does not converge: whether a program without a reach is infeasible or
// unbounded is left to the simplex method.  Deterministic, whatever the executor; checks `stop` before every iteration
// and within factorisations.
// REQUIRES: lower <= upper, no NaN.
[[nodiscard]] LpSolution solve_by_interior_point(const LinearProgram& program,
                                                 const InteriorPointSettings& settings = {}, std::stop_token stop = {},
                                                 const Executor& executor = serial());

}  // namespace selvage::lp::interior_point
