// The ways in which COIN-OR Clp can be asked for a linear program's optimum, to be measured beside our own.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::bench {

enum class ClpVariant {
  kDual,             // dual simplex
  kDualPresolved,    // the same after a presolve: what core/lp/clp.cpp does
  kPrimal,           // primal simplex
  kPrimalPresolved,  // the same after a presolve
  kDualised,         // dual simplex on the dual program, whose solution is carried back
  kBarrier,          // interior point, with crossover to a vertex
  kBarrierNoVertex,  // interior point alone
};

// Feasible to 1e-9, as in core/lp/clp.cpp.  No duals.
[[nodiscard]] lp::LpSolution solve_by_clp(const lp::LinearProgram& program, ClpVariant variant);

}  // namespace selvage::bench
