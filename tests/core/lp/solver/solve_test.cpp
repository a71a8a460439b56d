// Programs that one of the solvers cannot solve.
#include "core/lp/solver/solve.h"

#include <gtest/gtest.h>

namespace selvage::lp::solver {
namespace {

// A chain of columns, each at least 1 larger than the one before.  The first is at least 0, the last at most `room`.
LinearProgram chain(int columns, double room) {
  LinearProgram program;
  for (int j = 0; j < columns; ++j) program.add_column(1, 0, j + 1 < columns ? kInfinity : room);
  for (int j = 0; j + 1 < columns; ++j) {
    const LinearProgram::Entry entries[]{{j, -1}, {j + 1, 1}};
    program.add_row(entries, 1);
  }
  return program;
}

TEST(Solve, TellsThatALargeProgramIsInfeasible) {
  for (const int columns : {100, 3000, 8000}) {
    EXPECT_EQ(solve(chain(columns, columns - 1), SolverChoice::kAutomatic).status, LpStatus::kOptimal) << columns;
    EXPECT_EQ(solve(chain(columns, columns - 2), SolverChoice::kAutomatic).status, LpStatus::kInfeasible) << columns;
  }
}

}  // namespace
}  // namespace selvage::lp::solver
