// By how little the rows of a linear program would have to give way for a point to be feasible.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::lp {

// Minimise the amount, its last column, by which every row of `program` gives way at a point within the column bounds.
// Always has a best point: down to -1 the amount counts.  Above 0 there its prices prove that `program` is infeasible;
// else the point is feasible in `program`, and inside if that has an inside.
[[nodiscard]] LinearProgram phase_one_program(const LinearProgram& program);

}  // namespace selvage::lp
