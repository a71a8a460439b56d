// The simplex method: COIN-OR Clp, of which nothing shows here.
#pragma once

#include <stop_token>

#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

// A vertex solution, feasible to 1e-9, whose prices certify it (core/lp/certificate.h): Clp's word is not enough.
// kFailed when no way of asking Clp gives one.  Costs below 1e-7 may count as none.  Stops at the next pivot once
// `stop` is requested. REQUIRES: lower <= upper, no NaN, at least one column.
[[nodiscard]] LpSolution solve_by_simplex(const LinearProgram& program, int pivot_limit, std::stop_token stop = {});

}  // namespace selvage::lp::solver
