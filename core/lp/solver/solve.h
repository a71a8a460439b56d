// The linear program solvers behind one function.
//
// Small programs, and those where a vertex matters, are solved by the simplex method (COIN-OR Clp), large ones by the
// interior point method; each is the fallback of the other, except that simplex, which would take minutes, is not tried
// on programs of thousands of columns.  When simplex finds no optimum, the result is confirmed by the interior point
// method on the phase one program (core/lp/phase_one_program.h); where a large program has no solution, the phase one
// program shows it without simplex.
#pragma once

#include <stop_token>

#include "core/base/executor.h"
#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

enum class SolverChoice { kAutomatic, kSimplex, kInteriorPoint };

struct LpLimits {
  int iterations{100'000};  // limit of simplex pivots; the interior point method has its own, far smaller limit
  double tolerance{};  // relative to 1 + |objective|: the interior point method's objective may exceed the optimum by
                       // this much; 0: as exact as rounding allows.  Vertex solutions are always optimal
  bool falls_back{true};    // to simplex where the interior point method fails; else the program counts as failed
  double reach{kInfinity};  // solutions with larger columns are of no use: a program without a nearer one may be called
                            // infeasible
};

// Deterministic, whatever the executor, whose threads share the work on large programs.  Returns kStopped soon after
// `stop` is requested.
[[nodiscard]] LpSolution solve(const LinearProgram& program, SolverChoice choice, const LpLimits& limits = {},
                               std::stop_token stop = {}, const Executor& executor = serial());

// The largest row violation at which a solution is accepted: 1e-9, unless the rounding of the program's bounds allows
// no better.
[[nodiscard]] double allowed_violation(const LinearProgram& program);

}  // namespace selvage::lp::solver
