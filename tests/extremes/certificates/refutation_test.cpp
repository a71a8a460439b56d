// Programs without an optimum: solve() detects them, and a proof in rational arithmetic confirms it, whichever solver
// suggested the proof.
#include "tests/extremes/certificates/refutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/phase_one_program.h"
#include "core/lp/solver/clp.h"
#include "core/lp/solver/solve.h"
#include "tests/extremes/certificates/exact_certificate.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/row_of_points.h"
#include "tests/support/random.h"

namespace selvage::test {
namespace {

using test::descent_program;
using test::falls_for_ever_by;
using test::infeasible_by;
using test::kLatticeUnit;
using test::Random;
using test::reached;
using test::row_of_points;
using Row = std::vector<lp::LinearProgram::Entry>;

constexpr std::array kChoices{lp::solver::SolverChoice::kAutomatic, lp::solver::SolverChoice::kSimplex,
                              lp::solver::SolverChoice::kInteriorPoint};

// The solutions of each solver alone.
std::array<lp::LpSolution, 2> both_answers(const lp::LinearProgram& program) {
  return {lp::solver::solve_by_simplex(program, kPivots), lp::interior_point::solve_by_interior_point(program)};
}

void expect_said(const lp::LinearProgram& program, lp::LpStatus status) {
  for (const lp::solver::SolverChoice choice : kChoices) EXPECT_EQ(solve(program, choice).status, status);
}

// The smaller of the two proved amounts.
double expect_infeasible(const lp::LinearProgram& program) {
  expect_said(program, lp::LpStatus::kInfeasible);
  double least = lp::kInfinity;
  for (const lp::LpSolution& answer : both_answers(phase_one_program(program))) {
    EXPECT_EQ(answer.status, lp::LpStatus::kOptimal);
    const double proved = infeasible_by(program, answer.dual);
    EXPECT_GT(proved, 0);
    EXPECT_LE(proved, answer.objective + 1e-8);  // no more than the amount by which the rows must be relaxed
    least = std::min(least, proved);
  }
  return least;
}

double expect_unbounded(const lp::LinearProgram& program) {
  expect_said(program, lp::LpStatus::kUnbounded);
  double least = lp::kInfinity;
  const auto points = both_answers(phase_one_program(program));
  const auto rays = both_answers(descent_program(program));
  for (std::size_t k = 0; k < rays.size(); ++k) {
    EXPECT_EQ(points[k].status, lp::LpStatus::kOptimal);
    EXPECT_EQ(rays[k].status, lp::LpStatus::kOptimal);
    const std::span point{points[k].x.data(), program.cost.size()};
    least = std::min(least, falls_for_ever_by(program, point, rays[k].x));
  }
  EXPECT_GT(least, 0);
  return least;
}

lp::LinearProgram free_columns(int count) {
  lp::LinearProgram program;
  for (int j = 0; j < count; ++j) program.add_column(0, -lp::kInfinity, lp::kInfinity);
  return program;
}
void add_equality(lp::LinearProgram& program, const Row& row, double right) {
  Row opposite = row;
  for (auto& [column, value] : opposite) value = -value;
  program.add_row(row, right);
  program.add_row(opposite, -right);
}

TEST(Refutation, ProvesNothingOfWhatHasAnAnswer) {
  lp::LinearProgram program = row_of_points(3, 1);
  EXPECT_LE(infeasible_by(program, std::vector<double>{1, 1, 1}), 0);  // the rows add up to a satisfied row
  EXPECT_EQ(infeasible_by(program, std::vector<double>{1, 1, 0}), 0);  // a free column keeps a coefficient
  EXPECT_EQ(infeasible_by(program, std::vector<double>{0, 0, 0}), 0);
  const std::vector<double> point{0, 1, 2};
  EXPECT_LE(falls_for_ever_by(program, point, std::vector<double>{1, 1, 1}),
            0);  // violates rows, and increases the cost
  EXPECT_LE(falls_for_ever_by(program, point, std::vector<double>{-1, -1, -1}),
            0);  // decreases the cost, but violates a bound
  EXPECT_LE(falls_for_ever_by(program, point, std::vector<double>{0, 0, 0}), 0);
}

TEST(Refutation, TakesNoPriceBelowZeroAndNoPointOutside) {
  lp::LinearProgram apart = free_columns(1);
  apart.add_row(Row{{0, 1}}, 1);
  apart.add_row(Row{{0, 1}}, 2);
  EXPECT_EQ(infeasible_by(apart, std::vector<double>{-1, 1}), 0);  // the second row minus the first requires 0 >= 1
  lp::LinearProgram falls;
  falls.add_column(-1, 0, lp::kInfinity);
  EXPECT_EQ(falls_for_ever_by(falls, std::vector<double>{0}, std::vector<double>{2}), 1);
  EXPECT_EQ(falls_for_ever_by(falls, std::vector<double>{-3}, std::vector<double>{2}), 0);
}

TEST(Refutation, MakesExactWhatIsNot) {  // one third is not a double
  lp::LinearProgram program = free_columns(1);
  program.add_row(Row{{0, 3}}, 1);
  program.add_row(Row{{0, -1}}, 0);
  EXPECT_EQ(infeasible_by(program, std::vector<double>{1.0 / 3 + 1e-12, 1}), 0.25);
}

TEST(ExtremePrograms, InfeasibleByOneLatticeUnit) {
  for (const int points : {2, 10, 100, 400}) {
    SCOPED_TRACE(points);
    const double proved = expect_infeasible(row_of_points(points, -1));
    EXPECT_NEAR(proved * points / kLatticeUnit, 1, 1e-6);  // the unit is distributed among the rows
    for (const lp::solver::SolverChoice choice : kChoices) {
      for (const double spare : {0.0, 1.0}) {
        const lp::LinearProgram program = row_of_points(points, spare);
        const lp::LpSolution solution = solve(program, choice);
        ASSERT_EQ(solution.status, lp::LpStatus::kOptimal) << spare;
        EXPECT_LE(test::exact_certificate(program, solution).primal, 1e-9);
      }
    }
  }
  reached("lattice units spread over 400 rows", 1);
}

TEST(ExtremePrograms, InfeasibleByBoundsOnly) {
  lp::LinearProgram program;
  for (int j = 0; j < 50; ++j) program.add_column(j % 3 - 1, 0, 1);
  Row all;
  for (int j = 0; j < 50; ++j) all.push_back({j, 1});
  program.add_row(all, 50);
  EXPECT_NEAR(solve(program, lp::solver::SolverChoice::kAutomatic).objective, -1, 1e-7);
  program.bound[0] += kLatticeUnit;
  EXPECT_NEAR(expect_infeasible(program), kLatticeUnit, 1e-12);
}

TEST(ExtremePrograms, EqualitiesThatContradict) {
  for (const double by : {1.0, 1e-3, 1e-6}) {
    SCOPED_TRACE(by);
    lp::LinearProgram two = free_columns(2);
    add_equality(two, Row{{0, 1}, {1, 1}}, 1);
    add_equality(two, Row{{0, 1}, {1, -1}}, 0);
    add_equality(two, Row{{0, 1}}, 0.5 + by);
    expect_infeasible(two);

    lp::LinearProgram circle =
        free_columns(30);  // each is a third more than the previous one, and the first than the last
    for (int j = 0; j < 30; ++j)
      add_equality(circle, Row{{(j + 1) % 30, 1}, {j, -1}}, j < 29 ? 1.0 / 3 : by - 29.0 / 3);
    expect_infeasible(circle);
  }
}

// A thousand rows meet at one point, and only two of them contradict each other.
TEST(ExtremePrograms, InfeasibleWhereManyRowsMeet) {
  Random random{5};
  lp::LinearProgram program = free_columns(6);
  std::array<double, 6> at{1, -1, 0.5, 0, 2, -0.25};
  for (int r = 0; r < 1000; ++r) {
    Row row;
    double bound = 0;
    for (int j = 0; j < 6; ++j) {
      row.push_back({j, static_cast<double>(random.between(-8, 8)) / 8});
      bound += row.back().value * at[static_cast<std::size_t>(j)];
    }
    program.add_row(row, bound);
  }
  const Row last{{0, 0.5}, {3, -0.25}, {4, 1}};
  add_equality(program, last, 2.5);
  for (const lp::LpSolution& solution : both_answers(program)) EXPECT_EQ(solution.status, lp::LpStatus::kOptimal);
  program.bound.back() += 1e-5;
  expect_infeasible(program);
}

// A column without a bound is reported as unbounded; a column with a distant bound is not.
TEST(ExtremePrograms, UnboundedAndAllButUnbounded) {
  for (const double cost : {-1.0, -1e-3, -1e-6}) {
    lp::LinearProgram program = row_of_points(300, 1);
    const int loose = program.add_column(cost, -lp::kInfinity, lp::kInfinity);
    program.add_row(Row{{loose, 1}, {0, -1}}, 0);
    EXPECT_NEAR(expect_unbounded(program) / cost, -1, 1e-9);
    program.add_row(Row{{loose, -1}}, -1e9);
    for (const lp::solver::SolverChoice choice : kChoices) {
      const lp::LpSolution solution = solve(program, choice);
      ASSERT_EQ(solution.status, lp::LpStatus::kOptimal) << cost;
      EXPECT_NEAR(solution.x[static_cast<std::size_t>(loose)] / 1e9, 1, 1e-9);
    }
  }
  reached("bound of a column whose cost is 1e-6", 1e9);
}

// The only unbounded direction is a line that rows enclose from both sides.
TEST(ExtremePrograms, UnboundedAlongALine) {
  lp::LinearProgram program = free_columns(20);
  for (int j = 0; j < 19; ++j) add_equality(program, Row{{j + 1, 1}, {j, -0.9}}, 0.1);
  program.cost[19] = 1;
  expect_unbounded(program);
}

double eighths(Random& random, int low, int high) {
  return static_cast<double>(random.between(low, high)) / 8;
}

// Every column has a cost.  `eighths_of`: percentage of rows with exactly representable coefficients.
lp::LinearProgram random_rows(Random& random, int columns, int rows, int eighths_of) {
  lp::LinearProgram program;
  for (int j = 0; j < columns; ++j) program.add_column(eighths(random, 1, 8) * (random.chance(50) ? 1 : -1), -1, 1);
  for (int r = 0; r < rows; ++r) {
    const bool exact = random.chance(eighths_of);
    Row row;
    for (int j = 0; j < columns; ++j) {
      if (random.chance(60)) row.push_back({j, exact ? eighths(random, -8, 8) : random.part() * 2 - 1});
    }
    program.add_row(row, exact ? 0 : -random.part());
  }
  return program;
}

// The last row requires more than the others allow, by `by`.
lp::LinearProgram random_infeasible(Random& random, double by) {
  const auto columns = static_cast<int>(random.between(1, 8));
  const auto rows = static_cast<int>(random.between(1, 25));
  const bool endless = random.chance(50);  // the coefficients of free columns must then add up to exactly zero
  lp::LinearProgram program = random_rows(random, columns, rows, endless ? 100 : 50);
  Row last;
  for (int j = 0; j < columns; ++j) {
    const auto k = static_cast<std::size_t>(j);
    if (endless && random.chance(50)) program.lower[k] = -lp::kInfinity;
    if (endless && random.chance(50)) program.upper[k] = lp::kInfinity;
    last.push_back({j, 0});
  }
  double asked = 0;
  for (int r = 0; r < rows; ++r) {
    const double price = eighths(random, 0, 8);
    asked += price * program.bound[static_cast<std::size_t>(r)];
    for (const auto& [column, value] : program.row(r)) last[static_cast<std::size_t>(column)].value -= price * value;
  }
  program.add_row(last, by - asked);
  return program;
}

// The smallest proved amount over many random programs.
template <class Refute>
double least_at_random(std::uint32_t seed, const Refute& refute) {
  Random random{seed};
  double least = lp::kInfinity;
  constexpr int kPrograms = 1000 / test::kSlowdown;
  for (int trial = 0; trial < kPrograms; ++trial) {
    SCOPED_TRACE(trial);
    least = std::min(least, refute(random));
  }
  reached("programs", kPrograms);
  return least;
}

TEST(ExtremePrograms, InfeasibleAtRandom) {
  const double least = least_at_random(6, [](Random& random) {
    const double by = std::pow(10.0, -static_cast<double>(random.between(0, 5)));
    return expect_infeasible(random_infeasible(random, by));
  });
  reached("infeasible by, the least", least);
}

// The rows are satisfied at some point and along a direction from it in which the cost decreases without bound; half of
// them are active all along.
lp::LinearProgram random_unbounded(Random& random) {
  const auto columns = static_cast<int>(random.between(1, 8));
  lp::LinearProgram program = random_rows(random, columns, static_cast<int>(random.between(0, 25)), 50);
  std::vector<double> way, point;
  for (std::size_t j = 0; j < program.cost.size(); ++j) {
    way.push_back(j > 0 && random.chance(30) ? 0 : eighths(random, 1, 8) * (program.cost[j] > 0 ? -1 : 1));
    point.push_back(eighths(random, -8, 8));
    if (way.back() < 0 || random.chance(30)) program.lower[j] = -lp::kInfinity;
    if (way.back() > 0 || random.chance(30)) program.upper[j] = lp::kInfinity;
  }
  for (std::size_t r = 0; r < program.bound.size(); ++r) {
    const std::span row{program.entries.data() + program.row_start[r], program.row_start[r + 1] - program.row_start[r]};
    double along = 0;
    for (const auto& [column, value] : row) along += value * way[static_cast<std::size_t>(column)];
    for (auto& [column, value] : row) {
      if (along < 0) value = -value;
      program.bound[r] += value * point[static_cast<std::size_t>(column)];
    }
  }
  return program;
}

TEST(ExtremePrograms, UnboundedAtRandom) {
  const double least = least_at_random(7, [](Random& random) { return expect_unbounded(random_unbounded(random)); });
  reached("cost falls by, the least", least);
}

// Without costs every feasible point is optimal, and one exists; the dual simplex method once reported otherwise.
TEST(ExtremePrograms, FeasibleAtRandom) {
  Random random{8};
  constexpr int kPrograms = 1000 / test::kSlowdown;
  for (int trial = 0; trial < kPrograms; ++trial) {
    SCOPED_TRACE(trial);
    lp::LinearProgram program = random_unbounded(random);
    std::fill(program.cost.begin(), program.cost.end(), 0);
    expect_said(program, lp::LpStatus::kOptimal);
  }
}

}  // namespace
}  // namespace selvage::test
