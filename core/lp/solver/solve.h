// The solvers behind one call [design: solve].  Simplex (COIN-OR Clp) for small models and where a vertex matters; the
// interior point method for large ones; each of them again when the other fails.  That there is no best point is for
// simplex to say and for the other to confirm (core/lp/shortage.h).
#pragma once

#include <stop_token>

#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

enum class SolverChoice { kAutomatic, kSimplex, kInteriorPoint };

struct LpLimits {
  int iterations{100'000};  // simplex pivots; the interior point method has its own far smaller limit
  double tolerance{};  // of 1 + |objective|: by so much the interior point method's answer may be worse than the best;
                       // 0: as good as rounding lets it be.  A vertex is never worse
};

// Deterministic.  Stops soon after `stop` is requested, with kStopped.
[[nodiscard]] LpSolution solve(const LinearProgram& program, SolverChoice choice, const LpLimits& limits = {},
                               std::stop_token stop = {});

}  // namespace selvage::lp::solver
