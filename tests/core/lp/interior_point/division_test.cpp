// Programs large enough to be divided: the laws of the division, and the same solution on any number of threads.
#include "core/lp/interior_point/division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/lp/interior_point/interior_point.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/lp/compaction_models.h"

namespace selvage::lp::interior_point {
namespace {

constexpr int kSize = InteriorPointSettings{}.domain_size;

LinearProgram long_program(std::uint64_t seed = 1) {
  LinearProgram program = compaction_program({.points = 1600, .seed = seed});
  for (const std::size_t fixed : {100U, 101U, 2000U}) program.lower[fixed] = program.upper[fixed] = 0;
  return program;
}

TEST(Division, LeavesShortProgramsWhole) {
  EXPECT_TRUE(division(compaction_program({.points = 990}), kSize).domains.empty());
  EXPECT_TRUE(division({}, kSize).domains.empty());
}

TEST(Division, GivesEveryRowAndColumnAPlace) {
  const LinearProgram program = long_program();
  const Division divided = division(program, kSize);
  ASSERT_EQ(divided.domains.size(), 3U);
  ASSERT_FALSE(divided.border.empty());
  EXPECT_LT(divided.border.size(), 200U);
  std::map<int, int> rows, columns;
  for (const Division::Domain& domain : divided.domains) {
    ASSERT_EQ(domain.columns.size(), static_cast<std::size_t>(domain.own) + domain.border.size());
    for (std::size_t k = 0; k < domain.columns.size(); ++k) {
      const auto own = static_cast<std::size_t>(domain.own);
      if (k < own) {
        ++columns[domain.columns[k]];
      } else {
        EXPECT_EQ(domain.columns[k], divided.border[static_cast<std::size_t>(domain.border[k - own])]);
      }
    }
    for (const int r : domain.rows) {
      ++rows[r];
      for (const auto& [column, value] : program.row(r)) {
        const auto j = static_cast<std::size_t>(column);
        const bool moves = program.lower[j] != program.upper[j];
        EXPECT_EQ(std::ranges::count(domain.columns, column), moves ? 1 : 0);
      }
    }
  }
  for (const int column : divided.border) ++columns[column];
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(program.rows()));
  EXPECT_EQ(columns.size(), static_cast<std::size_t>(program.columns()) - 3);
  for (const auto& [row, times] : rows) EXPECT_EQ(times, 1) << "row " << row;
  for (const auto& [column, times] : columns) EXPECT_EQ(times, 1) << "column " << column;
}

// Costs and bounds of a column of the border are with one domain; a fixed column is in the rows' bounds.
TEST(Division, AddsUpToTheProgram) {
  LinearProgram program = long_program();
  program.lower[100] = program.upper[100] = 0.5;
  const Division divided = division(program, kSize);
  std::vector<double> cost(program.cost.size(), 0.0);
  for (std::size_t d = 0; d < divided.domains.size(); ++d) {
    const Division::Domain& domain = divided.domains[d];
    const LinearProgram part = domain_program(program, divided, d);
    ASSERT_EQ(part.cost.size(), domain.columns.size());
    ASSERT_EQ(part.bound.size(), domain.rows.size());
    for (std::size_t k = 0; k < domain.columns.size(); ++k) {
      cost[static_cast<std::size_t>(domain.columns[k])] += part.cost[k];
    }
    for (std::size_t r = 0; r < domain.rows.size(); ++r) {
      double bound = program.bound[static_cast<std::size_t>(domain.rows[r])];
      for (const auto& [column, value] : program.row(domain.rows[r])) bound -= column == 100 ? value * 0.5 : 0;
      EXPECT_EQ(part.bound[r], bound);
    }
  }
  for (std::size_t j = 0; j < cost.size(); ++j) {
    EXPECT_EQ(cost[j], program.lower[j] == program.upper[j] ? 0 : program.cost[j]);
  }
}

TEST(Division, SolvesTheSameOnAnyNumberOfThreads) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const LinearProgram program = long_program(seed);
    const LpSolution expected = solve_by_interior_point(program);
    ASSERT_EQ(expected.status, LpStatus::kOptimal);
    for (const std::size_t threads : {1U, 2U, 4U}) {
      const protocol::execution::ThreadPool pool{threads - 1};
      const LpSolution solution = solve_by_interior_point(program, {}, {}, pool);
      EXPECT_EQ(solution.x, expected.x) << threads << " threads";
      EXPECT_EQ(solution.dual, expected.dual) << threads << " threads";
      EXPECT_EQ(solution.iterations, expected.iterations);
    }
  }
}

// The whole program and its domains, of all sizes, have the same optimum.
TEST(Division, SolvesLikeTheUndividedMethod) {
  for (const int points : {1, 2, 7, 30, 100, 400}) {
    const LinearProgram program = compaction_program({.points = points, .across = 5});
    const LpSolution expected = solve_by_interior_point(program, {.domain_size = points + 1});
    ASSERT_EQ(expected.status, LpStatus::kOptimal);
    for (const int size : {1, 3, 20, 60, 200}) {
      const LpSolution solution = solve_by_interior_point(program, {.domain_size = size});
      ASSERT_EQ(solution.status, LpStatus::kOptimal) << points << " points in domains of " << size;
      EXPECT_NEAR(solution.objective, expected.objective, 1e-8 * (1 + std::abs(expected.objective)));
      EXPECT_LE(infeasibility(program, solution.x), 1e-9);
    }
  }
}

TEST(Division, IsCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(solve_by_interior_point(long_program(), {}, stop.get_token()).status, LpStatus::kStopped);
}

}  // namespace
}  // namespace selvage::lp::interior_point
