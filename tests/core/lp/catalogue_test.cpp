// A catalogue of small linear programs with known solutions that every solver must pass.
#include <gtest/gtest.h>

#include <cmath>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/solver/clp.h"
#include "core/lp/solver/solve.h"

namespace selvage::lp {
namespace {

using Row = std::pair<std::vector<LinearProgram::Entry>, double>;

struct Case {
  const char* name;
  std::vector<double> cost, lower, upper;
  std::vector<Row> rows;
  LpStatus status;
  double objective{};

  [[nodiscard]] LinearProgram program() const {
    LinearProgram made;
    for (std::size_t j = 0; j < cost.size(); ++j) made.add_column(cost[j], lower[j], upper[j]);
    for (const auto& [entries, bound] : rows) made.add_row(entries, bound);
    return made;
  }
};

constexpr double kFree = kInfinity;

const std::vector<Case>& catalogue() {
  static const std::vector<Case> cases{
      {"two_rows",
       {1, 1},
       {0, 0},
       {kFree, kFree},
       {{{{0, 1}, {1, 2}}, 4}, {{{0, 3}, {1, 1}}, 6}},
       LpStatus::kOptimal,
       2.8},
      {"bounds_only", {1, -1}, {-2, -3}, {5, 7}, {}, LpStatus::kOptimal, -9},
      {"fixed_column", {1, 1}, {3, 0}, {3, 10}, {{{{0, 1}, {1, 1}}, 5}}, LpStatus::kOptimal, 5},
      {"all_fixed", {1, 2}, {3, 4}, {3, 4}, {{{{0, 1}, {1, 1}}, 7}}, LpStatus::kOptimal, 11},
      {"all_fixed_and_broken", {1, 2}, {3, 4}, {3, 4}, {{{{0, 1}, {1, 1}}, 7.5}}, LpStatus::kInfeasible},
      {"free_column_without_cost",
       {1, 0},
       {0, -kFree},
       {kFree, kFree},
       {{{{0, 1}, {1, 1}}, 1}, {{{0, 1}, {1, -1}}, 1}},
       LpStatus::kOptimal,
       1},
      {"degenerate_corner",
       {-1, -1},
       {0, 0},
       {kFree, kFree},
       {{{{0, -1}}, -1}, {{{1, -1}}, -1}, {{{0, -1}, {1, -1}}, -2}, {{{0, -2}, {1, -1}}, -3}},
       LpStatus::kOptimal,
       -2},
      {"redundant_rows",
       {1},
       {-kFree},
       {kFree},
       {{{{0, 1}}, 1}, {{{0, 1}}, 1}, {{{0, 2}}, 2}, {{{0, 1}}, 0}},
       LpStatus::kOptimal,
       1},
      {"opposite_rows_no_interior",
       {1, 1},
       {-kFree, -kFree},
       {kFree, kFree},
       {{{{0, 1}, {1, -1}}, 2}, {{{0, -1}, {1, 1}}, -2}, {{{0, 1}, {1, 1}}, 4}},
       LpStatus::kOptimal,
       4},
      {"a_single_point",
       {1, -1},
       {-kFree, -kFree},
       {kFree, kFree},
       {{{{0, 1}}, 2}, {{{0, -1}}, -2}, {{{1, 1}}, 3}, {{{1, -1}}, -3}},
       LpStatus::kOptimal,
       -1},
      {"empty_row_that_holds", {1}, {0}, {1}, {{{}, -1}}, LpStatus::kOptimal, 0},
      {"empty_row_that_does_not", {1}, {0}, {1}, {{{}, 1}}, LpStatus::kInfeasible},
      {"empty_column", {1, 2}, {1, 1}, {kFree, kFree}, {{{{0, 1}}, 5}}, LpStatus::kOptimal, 7},
      {"infeasible", {1}, {0}, {1}, {{{{0, 1}}, 2}}, LpStatus::kInfeasible},
      {"infeasible_by_a_hair",
       {0, 0},
       {-kFree, -kFree},
       {kFree, kFree},
       {{{{0, 1}, {1, 1}}, 1}, {{{0, -1}, {1, -1}}, -1 + 1e-6}},
       LpStatus::kInfeasible},
      {"feasible_by_a_hair",
       {1, 0},
       {-kFree, 0},
       {kFree, 0},
       {{{{0, 1}, {1, 1}}, 1}, {{{0, -1}, {1, -1}}, -1 - 1e-6}},
       LpStatus::kOptimal,
       1},
      {"unbounded", {-1}, {0}, {kFree}, {{{{0, 1}}, 1}}, LpStatus::kUnbounded},
      {"badly_scaled",
       {1e-4, 1},
       {0, 0},
       {kFree, kFree},
       {{{{0, 1e-3}, {1, 1}}, 1}, {{{0, 1}}, 10}},
       LpStatus::kOptimal,
       0.1},
      {"infeasible_while_the_cost_falls_for_ever",
       {-1, 0},
       {-kFree, -kFree},
       {kFree, kFree},
       {{{{1, 1}}, 1}, {{{1, -1}}, 0}},
       LpStatus::kInfeasible},
      // The cosine of a right angle, which is rounding noise.  Clp takes it as the scale of its row and then accepts
      // -0.914 as optimal.
      {"rounding_noise_in_a_row",
       {0, 0, -1},
       {-1, -1, -kFree},
       {1, 1, 1},
       {{{{0, 0.875}, {1, 0.5}, {2, -1.375}}, -0.25}, {{{0, 6e-17}, {1, 1}, {2, -1}}, -0.65}},
       LpStatus::kOptimal,
       -1},
      {"crossed_bounds", {1}, {2}, {1}, {}, LpStatus::kInfeasible},
      {"not_a_number", {std::nan("")}, {0}, {1}, {}, LpStatus::kFailed},
  };
  return cases;
}

void expect_certificate(const LinearProgram& program, const LpSolution& solution) {
  EXPECT_LE(infeasibility(program, solution.x), 1e-8);
  for (const double price : solution.dual) EXPECT_GE(price, 0);
}

class EverySolver : public testing::TestWithParam<solver::SolverChoice> {};

TEST_P(EverySolver, SolvesTheCatalogue) {
  for (const Case& c : catalogue()) {
    SCOPED_TRACE(c.name);
    const LinearProgram program = c.program();
    const LpSolution solution = solve(program, GetParam());
    EXPECT_EQ(solution.status, c.status);
    if (c.status != LpStatus::kOptimal || solution.status != LpStatus::kOptimal) continue;
    EXPECT_NEAR(solution.objective, c.objective, 1e-7);
    expect_certificate(program, solution);
  }
}

TEST_P(EverySolver, ReturnsAtOnceWhenAlreadyCancelled) {
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(solve(catalogue()[0].program(), GetParam(), {}, source.get_token()).status, LpStatus::kStopped);
}

INSTANTIATE_TEST_SUITE_P(Choices, EverySolver,
                         testing::Values(solver::SolverChoice::kAutomatic, solver::SolverChoice::kSimplex,
                                         solver::SolverChoice::kInteriorPoint),
                         [](const auto& param) {
                           switch (param.param) {
                             case solver::SolverChoice::kSimplex: return "Simplex";
                             case solver::SolverChoice::kInteriorPoint: return "InteriorPoint";
                             default: return "Automatic";
                           }
                         });

TEST(Simplex, ReportsWhenThePivotLimitIsReached) {
  LinearProgram program;
  std::vector<LinearProgram::Entry> row;
  for (int j = 0; j < 40; ++j) program.add_column(1 + j % 3, 0, kInfinity);
  for (int r = 0; r < 55; ++r) {
    row.clear();
    for (int j = r % 5; j < 40; j += 1 + r % 4) row.push_back({j, 1.0 + (r * j) % 7});
    program.add_row(row, 10 + r);
  }
  EXPECT_EQ(solver::solve_by_simplex(program, 1).status, LpStatus::kWorkLimit);
  EXPECT_EQ(solver::solve_by_simplex(program, 10'000).status, LpStatus::kOptimal);
}

TEST(Infeasibility, IsTheLargestViolationOfRowsAndBounds) {
  const LinearProgram program = catalogue()[0].program();
  EXPECT_EQ(infeasibility(program, std::vector<double>{4, 0}), 0);
  EXPECT_EQ(infeasibility(program, std::vector<double>{4, -0.5}), 1);  // the first row is violated by 1
  EXPECT_EQ(infeasibility(program, std::vector<double>{100, -3}), 3);  // the bound is violated by 3
}

}  // namespace
}  // namespace selvage::lp
