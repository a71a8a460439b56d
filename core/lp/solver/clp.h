// The simplex method, by COIN-OR Clp.  No type of Clp appears in this header.
#pragma once

#include <stop_token>

#include "core/lp/linear_program.h"

namespace selvage::lp::solver {

// Returns a vertex solution, feasible to 1e-9, whose dual prices certify its optimality (core/lp/certificate.h), since
// Clp's own status is not always right.  kFailed when no configuration of Clp yields one.  Costs below 1e-7 may be
// treated as zero.  Stops at the next pivot once `stop` is requested.
// REQUIRES: lower <= upper, no NaN, at least one column.
[[nodiscard]] LpSolution solve_by_simplex(const LinearProgram& program, int pivot_limit, std::stop_token stop = {});

}  // namespace selvage::lp::solver
