// Both solvers on programs with the structure of a compaction step: the same optimum, feasible and certified by the
// dual prices.
#include "tests/core/lp/compaction_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/lp/certificate.h"
#include "core/lp/interior_point/interior_point.h"
#include "core/lp/solver/clp.h"
#include "core/lp/solver/solve.h"

namespace selvage::lp {
namespace {

void expect_optimal(const LinearProgram& program, const LpSolution& solution) {
  ASSERT_EQ(solution.status, LpStatus::kOptimal);
  const Certificate certificate = certificate_of(program, solution);
  EXPECT_LE(certificate.primal, 1e-8);
  EXPECT_LE(certificate.dual, 1e-7);
  // Hundreds of columns have bounds in the hundreds, so dual residuals of 1e-8 add up to a gap of several 1e-6.
  EXPECT_LE(certificate.gap, 1e-5);
  const double scale = 1 + std::abs(solution.objective);
  for (int r = 0; r < program.rows(); ++r) {
    double activity = 0;
    for (const auto& [column, value] : program.row(r)) activity += value * solution.x[static_cast<std::size_t>(column)];
    const auto k = static_cast<std::size_t>(r);
    EXPECT_LE(solution.dual[k] * (activity - program.bound[k]), 1e-6 * scale) << "row " << r;
  }
}

class CompactionModels : public testing::TestWithParam<int> {};

TEST_P(CompactionModels, BothSolversFindTheSameOptimum) {
  const bool large = GetParam() > 500;
  for (std::uint64_t seed = 1; seed <= (large ? 1U : 6U); ++seed) {
    for (const double tight : large ? std::vector{0.2} : std::vector{0.0, 0.2, 0.6}) {
      const LinearProgram program = compaction_program({.points = GetParam(), .tight = tight, .seed = seed});
      const LpSolution simplex = solver::solve_by_simplex(program, 1'000'000);
      const LpSolution interior = interior_point::solve_by_interior_point(program);
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", tight " << tight << ", iterations "
                                      << interior.iterations);
      ASSERT_EQ(interior.status, LpStatus::kOptimal);
      expect_optimal(program, simplex);
      expect_optimal(program, interior);
      EXPECT_NEAR(simplex.objective, interior.objective, 1e-7 * (1 + std::abs(simplex.objective)));
      EXPECT_LE(infeasibility(program, interior.x), 1e-9);  // what compaction relies on
    }
  }
}

TEST_P(CompactionModels, SolutionsAreBitIdenticalOnRepetition) {
  const LinearProgram program = compaction_program({.points = GetParam()});
  EXPECT_EQ(interior_point::solve_by_interior_point(program).x, interior_point::solve_by_interior_point(program).x);
  EXPECT_EQ(solver::solve_by_simplex(program, 1'000'000).x, solver::solve_by_simplex(program, 1'000'000).x);
}

TEST_P(CompactionModels,
       TheInteriorPointMethodConvergesWithoutGravity) {  // some columns are then free and without cost
  const LinearProgram program = compaction_program({.points = GetParam(), .gravity = 0});
  const LpSolution solution = solve(program, solver::SolverChoice::kInteriorPoint);
  expect_optimal(program, solution);
}

TEST_P(CompactionModels, ALargerToleranceNeedsFewerIterations) {
  const LinearProgram program = compaction_program({.points = GetParam()});
  const LpSolution best = solve(program, solver::SolverChoice::kInteriorPoint);
  ASSERT_EQ(best.status, LpStatus::kOptimal);
  int last = best.iterations;
  for (const double tolerance : {1e-6, 1e-3, 1e-1}) {
    const LpSolution solution = solve(program, solver::SolverChoice::kInteriorPoint, {.tolerance = tolerance});
    SCOPED_TRACE(testing::Message() << "tolerance " << tolerance);
    ASSERT_EQ(solution.status, LpStatus::kOptimal);
    const double scale = 1 + std::abs(best.objective);
    EXPECT_LE(solution.objective, best.objective + tolerance * scale);
    EXPECT_GE(solution.objective, best.objective - 1e-7 * scale);
    EXPECT_LE(infeasibility(program, solution.x), 1e-9);  // rows are met regardless of the tolerance
    EXPECT_LE(solution.iterations, last);
    last = solution.iterations;
  }
  EXPECT_LT(last, best.iterations);
}

INSTANTIATE_TEST_SUITE_P(Points, CompactionModels, testing::Values(3, 50, 200, 700));

TEST(CompactionModel, CanBeCancelledWhileSolving) {
  // Large enough to take many pivots and factorisations; a second thread requests the stop.
  const LinearProgram program = compaction_program({.points = 3000, .tight = 0.6});
  for (const solver::SolverChoice choice : {solver::SolverChoice::kSimplex, solver::SolverChoice::kInteriorPoint}) {
    std::stop_source source;
    std::jthread asking{[&] { source.request_stop(); }};
    const LpStatus status = solve(program, choice, {}, source.get_token()).status;
    EXPECT_TRUE(status == LpStatus::kStopped || status == LpStatus::kOptimal);
  }
}

TEST(InteriorPoint, AllowsForTheRoundingOfDistantBounds) {
  LinearProgram program;
  program.add_column(1, -kInfinity, 3);
  EXPECT_LT(interior_point::attainable_violation(program), 1e-13);
  program.add_column(1, -1e6, kInfinity);  // the way to the start of a strip that is a thousand widths long
  EXPECT_GT(interior_point::attainable_violation(program), 1e-9);
  EXPECT_LT(interior_point::attainable_violation(program), 1e-8);
}

}  // namespace
}  // namespace selvage::lp
