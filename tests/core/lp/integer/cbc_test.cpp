// Branch and cut against brute force, and the laws of its header.
#include "core/lp/integer/cbc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace selvage::lp::integer {
namespace {

// A knapsack problem as a minimisation: the value of 0 to 3 copies each of five items within a weight.
struct Knapsack {
  std::vector<int> worth, weight;
  int room{};

  [[nodiscard]] IntegerProgram program() const {
    IntegerProgram program;
    std::vector<LinearProgram::Entry> row;
    for (std::size_t k = 0; k < worth.size(); ++k)
      row.push_back({program.add_whole_column(-worth[k], 0, 3), -1.0 * weight[k]});
    program.linear.add_row(row, -room);
    return program;
  }
  [[nodiscard]] int best(std::size_t from, int left) const {
    if (from == worth.size()) return 0;
    int most = 0;
    for (int count = 0; count <= 3 && count * weight[from] <= left; ++count)
      most = std::max(most, count * worth[from] + best(from + 1, left - count * weight[from]));
    return most;
  }
};

Knapsack random_knapsack(std::mt19937_64& random) {
  Knapsack knapsack;
  for (int k = 0; k < 5; ++k) {
    knapsack.worth.push_back(1 + static_cast<int>(random() % 40));
    knapsack.weight.push_back(1 + static_cast<int>(random() % 20));
  }
  knapsack.room = 10 + static_cast<int>(random() % 60);
  return knapsack;
}

TEST(BranchAndCut, AgreesWithBruteForce) {
  std::mt19937_64 random{1};
  for (int k = 0; k < 50; ++k) {
    const Knapsack knapsack = random_knapsack(random);
    const IntegerProgram program = knapsack.program();
    const IntegerSolution solution = solve_by_branch_and_cut(program, {});
    ASSERT_EQ(solution.status, IntegerStatus::kOptimal);
    EXPECT_TRUE(is_solution(program, solution.x));
    EXPECT_NEAR(solution.objective, -knapsack.best(0, knapsack.room), 1e-6);
    EXPECT_LE(solution.bound, solution.objective);
  }
}

TEST(BranchAndCut, ReportsThatThereIsNoSolution) {
  IntegerProgram program;
  const int x = program.add_whole_column(1, 0, 10), y = program.add_whole_column(1, 0, 10);
  const LinearProgram::Entry row[] = {{x, 2}, {y, 2}}, opposite[] = {{x, -2}, {y, -2}};
  program.linear.add_row(row, 3);  // 2x + 2y is 3: no whole numbers are
  program.linear.add_row(opposite, -3);
  const IntegerSolution solution = solve_by_branch_and_cut(program, {});
  EXPECT_EQ(solution.status, IntegerStatus::kInfeasible);
  EXPECT_FALSE(solution.found());
  EXPECT_EQ(solution.bound, kInfinity);
}

TEST(BranchAndCut, IsNeverWorseThanItsStart) {
  std::mt19937_64 random{2};
  for (int k = 0; k < 20; ++k) {
    const IntegerProgram program = random_knapsack(random).program();
    const IntegerSolution best = solve_by_branch_and_cut(program, {});
    const IntegerSolution again = solve_by_branch_and_cut(program, {.nodes = 0}, best.x);
    ASSERT_TRUE(again.found());
    EXPECT_LE(again.objective, best.objective + 1e-9);
  }
}

TEST(BranchAndCut, KeepsItsStartWhenCancelled) {
  std::mt19937_64 random{3};
  const IntegerProgram program = random_knapsack(random).program();
  std::stop_source stop;
  stop.request_stop();
  const std::vector<double> nothing(5);
  const IntegerSolution solution = solve_by_branch_and_cut(program, {}, nothing, stop.get_token());
  EXPECT_EQ(solution.status, IntegerStatus::kStopped);
  EXPECT_EQ(solution.x, nothing);
  EXPECT_EQ(solution.bound, -kInfinity);
}

TEST(BranchAndCut, IsDeterministic) {
  std::mt19937_64 random{4};
  for (int k = 0; k < 10; ++k) {
    const IntegerProgram program = random_knapsack(random).program();
    const IntegerSolution one = solve_by_branch_and_cut(program, {}), other = solve_by_branch_and_cut(program, {});
    EXPECT_EQ(one.x, other.x);
    EXPECT_EQ(one.nodes, other.nodes);
    EXPECT_EQ(one.bound, other.bound);
  }
}

TEST(IsSolution, DetectsFractionsAndViolatedRows) {
  IntegerProgram program;
  const int x = program.add_whole_column(1, 0, 10);
  const LinearProgram::Entry row[] = {{x, 1}};
  program.linear.add_row(row, 2);
  EXPECT_TRUE(is_solution(program, std::vector{2.0}));
  EXPECT_FALSE(is_solution(program, std::vector{2.5}));
  EXPECT_FALSE(is_solution(program, std::vector{1.0}));
  EXPECT_FALSE(is_solution(program, std::vector{11.0}));
  EXPECT_FALSE(is_solution(program, std::vector{2.0, 0.0}));
}

}  // namespace
}  // namespace selvage::lp::integer
