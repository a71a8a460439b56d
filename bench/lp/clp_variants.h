// The configurations of COIN-OR Clp that are compared with our solvers.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::bench {

enum class ClpVariant {
  kDual,             // dual simplex
  kDualPresolved,    // dual simplex after presolve, which core/lp/solver/clp.cpp uses
  kPrimal,           // primal simplex
  kPrimalPresolved,  // primal simplex after presolve
  kDualised,         // dual simplex on the dual program, with the solution mapped back
  kBarrier,          // interior point, with crossover to a vertex
  kBarrierNoVertex,  // interior point alone
};

// Solutions are feasible to 1e-9, as in core/lp/solver/clp.cpp, and have no dual prices.
[[nodiscard]] lp::LpSolution solve_by_clp(const lp::LinearProgram& program, ClpVariant variant);

}  // namespace selvage::bench
