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

TEST(Solve, ProvesByItsPricesThatNothingWithinReachIsFeasible) {
  for (const int columns : {100, 3000}) {
    LpLimits limits;
    limits.reach = 10.0 * columns;
    limits.falls_back = false;  // so the answer is the interior point method's own
    const LpSolution solution = solve(chain(columns, columns - 2), SolverChoice::kInteriorPoint, limits);
    EXPECT_EQ(solution.status, LpStatus::kInfeasible) << columns;
    EXPECT_LT(solution.iterations, 60) << columns;
    limits.reach = columns;  // the only solution reaches as far as that, nearly
    EXPECT_EQ(solve(chain(columns, columns - 1), SolverChoice::kInteriorPoint, limits).status, LpStatus::kOptimal);
  }
}

// To prove so small a contradiction, prices would have to be larger than the method can make them.
TEST(Solve, GivesUpSoonWhereRowsAreInfeasibleByNextToNothing) {
  const LinearProgram program = chain(100, 99 - 1e-7);
  LpLimits limits{.falls_back = false, .reach = 1000};
  EXPECT_EQ(solve(program, SolverChoice::kInteriorPoint, limits).status, LpStatus::kFailed);
  limits.falls_back = true;
  EXPECT_EQ(solve(program, SolverChoice::kInteriorPoint, limits).status, LpStatus::kInfeasible);
}

}  // namespace
}  // namespace selvage::lp::solver
