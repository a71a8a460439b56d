// The phase one program: the least amount by which all rows of a linear program must be relaxed to make it feasible.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::lp {

// The program whose last column is the amount by which every row of `program` is relaxed, and whose objective is to
// minimise that amount within the column bounds.  It always has an optimum, since the amount is bounded below by -1.
// When the optimum is positive, the dual prices prove that `program` is infeasible.  Otherwise the point is feasible
// for `program`, and strictly inside its rows if it has a strictly feasible point.
[[nodiscard]] LinearProgram phase_one_program(const LinearProgram& program);

}  // namespace selvage::lp
