// Programs that are solved again only around the rows that a solution breaks.
#include "core/lp/solver/solve_locally.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stop_token>

#include "core/lp/solver/solve.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/lp/compaction_models.h"

namespace selvage::lp::solver {
namespace {

// A thousand columns from 0 to 10, each of which had best be small.
LinearProgram separate_columns() {
  LinearProgram program;
  for (int j = 0; j < 1000; ++j) program.add_column(1, 0, 10);
  return program;
}

// x[second] - x[first] >= bound.
void add_distance(LinearProgram& program, int first, int second, double bound) {
  const LinearProgram::Entry entries[]{{first, -1}, {second, 1}};
  program.add_row(entries, bound);
}

std::vector<double> zeros_but(const std::vector<std::pair<std::size_t, double>>& others) {
  std::vector<double> x(1000, 0.0);
  for (const auto& [column, value] : others) x[column] = value;
  return x;
}

TEST(SolveLocally, LeavesASolutionThatBreaksNothing) {
  LinearProgram program = separate_columns();
  add_distance(program, 3, 4, -1);
  const std::vector<double> x = zeros_but({{3, 0.5}});
  EXPECT_EQ(solved_locally(program, x), x);
}

TEST(SolveLocally, ChangesTheColumnsOfABrokenRow) {
  LinearProgram program = separate_columns();
  add_distance(program, 3, 4, 2);
  add_distance(program, 800, 700, 3);
  const auto x = solved_locally(program, zeros_but({{5, 7}}));
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, zeros_but({{4, 2}, {5, 7}, {700, 3}}));
}

TEST(SolveLocally, ChangesNeighboursWhereTheColumnsOfTheRowDoNotSuffice) {
  LinearProgram program = separate_columns();
  add_distance(program, 3, 4, 2);
  add_distance(program, 4, 5, 0);
  add_distance(program, 5, 6, -1.5);
  add_distance(program, 6, 7, -9);
  const auto x = solved_locally(program, zeros_but({}));
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, zeros_but({{4, 2}, {5, 2}, {6, 0.5}}));
}

TEST(SolveLocally, NeverMovesAFixedColumn) {
  LinearProgram program = separate_columns();
  program.upper[4] = 0;
  add_distance(program, 4, 3, 2);
  EXPECT_EQ(solved_locally(program, zeros_but({})), zeros_but({{3, 2}}));
  program.upper[3] = 1;
  EXPECT_FALSE(solved_locally(program, zeros_but({})));
}

TEST(SolveLocally, GivesUpWhereTooManyColumnsWouldChange) {
  LinearProgram program = separate_columns();
  for (int j = 0; j + 1 < 500; ++j) add_distance(program, j, j + 1, 0);
  program.bound[0] = 2;
  EXPECT_FALSE(solved_locally(program, zeros_but({})));
}

TEST(SolveLocally, EndsWhenCancelled) {
  LinearProgram program = separate_columns();
  add_distance(program, 3, 4, 2);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(solved_locally(program, zeros_but({}), stop.get_token()));
}

// Compaction steps that were solved without some of their rows.  They shorten the strip by a tenth of what is possible,
// so that there is room.
TEST(SolveLocally, MakesCompactionStepsFeasibleWithoutBeatingTheOptimum) {
  const protocol::execution::ThreadPool pool{3};
  int broken = 0;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    LinearProgram program = compaction_program({.points = 600, .tight = 0, .seed = seed});
    program.lower.back() = solve(program, SolverChoice::kAutomatic).x.back() / 10;
    LinearProgram fewer = program;
    fewer.entries.clear();
    fewer.row_start.assign(1, 0);
    fewer.bound.clear();
    for (int r = 0; r < program.rows(); ++r) {
      if (r % 997 != 0) fewer.add_row(program.row(r), program.bound[static_cast<std::size_t>(r)]);
    }
    const LpSolution solution = solve(fewer, SolverChoice::kAutomatic);
    const LpSolution best = solve(program, SolverChoice::kAutomatic);
    ASSERT_EQ(solution.status, LpStatus::kOptimal);
    ASSERT_EQ(best.status, LpStatus::kOptimal);
    if (infeasibility(program, solution.x) < 1e-6) continue;
    ++broken;
    const auto x = solved_locally(program, solution.x);
    if (!x) continue;
    ++found;
    EXPECT_LE(infeasibility(program, *x), allowed_violation(program));
    const double cost = std::inner_product(x->begin(), x->end(), program.cost.begin(), 0.0);
    EXPECT_GE(cost, best.objective - 1e-6 * (1 + std::abs(best.objective)));
    EXPECT_EQ(solved_locally(program, solution.x, {}, pool), x);
  }
  EXPECT_GE(broken, 20);
  EXPECT_GE(found, 5);
}

}  // namespace
}  // namespace selvage::lp::solver
