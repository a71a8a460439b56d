// Linear programs at the limits of floating point arithmetic: the solution of each solver is compared with the other's,
// and checked with a certificate in rational arithmetic.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/solver/clp.h"
#include "tests/core/lp/compaction_models.h"
#include "tests/extremes/certificates/exact_certificate.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/row_of_points.h"
#include "tests/support/random.h"

namespace selvage::test {
namespace {

using test::exact_certificate;
using test::ExactCertificate;
using test::Random;
using test::reached;
using test::row_of_points;
using Entry = lp::LinearProgram::Entry;

// The largest errors found in the solutions of one kind of program.
struct Worst {
  double primal{}, dual{}, gap{}, apart{};

  // `scale`: the magnitude of the terms that the objective is the sum of.
  void include(const lp::LinearProgram& program, double scale = 1) {
    const lp::LpSolution simplex = lp::solver::solve_by_simplex(program, kPivots);
    const lp::LpSolution interior = lp::interior_point::solve_by_interior_point(program);
    ASSERT_EQ(simplex.status, lp::LpStatus::kOptimal);
    ASSERT_EQ(interior.status, lp::LpStatus::kOptimal);
    apart = std::max(apart, std::abs(simplex.objective - interior.objective) / scale);
    for (const lp::LpSolution* solution : {&simplex, &interior}) {
      const ExactCertificate exact = exact_certificate(program, *solution);
      primal = std::max(primal, exact.primal);
      dual = std::max(dual, exact.dual);
      gap = std::max(gap, std::abs(exact.gap) / scale);
      EXPECT_NEAR(exact.objective, solution->objective, 1e-9 * scale);
    }
  }
  void expect_closed() const {
    reached("row broken by", primal);
    reached("price beyond its bound", dual);
    reached("duality gap", gap);
    reached("simplex and interior point apart", apart);
    EXPECT_LE(primal, 1e-8);
    EXPECT_LE(dual, 1e-8);
    EXPECT_LE(gap, 1e-7);
    EXPECT_LE(apart, 1e-7);
  }
};

// The largest square between lines at whole degrees; the cosines of right angles leave rounding noise of 6e-17 in the
// rows.
lp::LinearProgram square_between_lines(Random& random, int lines) {
  lp::LinearProgram program;
  program.add_column(0, -1, 1);
  program.add_column(0, -1, 1);
  program.add_column(-1, -lp::kInfinity, 1);
  for (int k = 0; k < lines; ++k) {
    const double angle = static_cast<double>(random.between(0, 359)) * std::numbers::pi / 180;
    const double room = static_cast<double>(random.between(-20, 199)) / 150;
    const std::array<Entry, 3> row{
        {{0, std::cos(angle)}, {1, std::sin(angle)}, {2, -std::abs(std::cos(angle)) - std::abs(std::sin(angle))}}};
    program.add_row(row, -room);
  }
  return program;
}

TEST(ExtremePrograms, DustInTheRows) {
  Random random{1};
  Worst worst;
  for (int trial = 0; trial < 2000 / test::kSlowdown; ++trial) {
    worst.include(square_between_lines(random, static_cast<int>(random.between(0, 60))));
  }
  worst.expect_closed();
}

// Every row passes through the optimal vertex.
TEST(ExtremePrograms, AThousandRowsThroughOneVertex) {
  Random random{2};
  Worst worst;
  for (int trial = 0; trial < 5; ++trial) {
    constexpr int kColumns = 12;
    lp::LinearProgram program;
    for (int j = 0; j < kColumns; ++j) program.add_column(0, -lp::kInfinity, lp::kInfinity);
    for (int r = 0; r < 1000; ++r) {
      std::vector<Entry> row;
      double at_vertex = 0;
      for (int j = 0; j < kColumns; ++j) {
        const double value = random.part() * 2 - 1;
        row.push_back({j, value});
        at_vertex += value * j;
        if (r < 20)
          program.cost[static_cast<std::size_t>(j)] += value;  // a sum of rows, so that this vertex is optimal
      }
      program.add_row(row, at_vertex);
    }
    worst.include(program, 100);
  }
  worst.expect_closed();
}

// Beale's program, on which the textbook simplex method cycles.
TEST(ExtremePrograms, WherePivotsGoRoundInACircle) {
  lp::LinearProgram program;
  for (const double cost : {-0.75, 150.0, -0.02, 6.0}) program.add_column(cost, 0, lp::kInfinity);
  program.add_row(std::vector<Entry>{{0, -0.25}, {1, 60}, {2, 0.04}, {3, -9}}, 0);
  program.add_row(std::vector<Entry>{{0, -0.5}, {1, 90}, {2, 0.02}, {3, -3}}, 0);
  program.add_row(std::vector<Entry>{{2, -1}}, -1);
  Worst worst;
  worst.include(program);
  worst.expect_closed();
  EXPECT_NEAR(lp::solver::solve_by_simplex(program, kPivots).objective, -0.05, 1e-9);
}

// The rows of a Hilbert matrix, which are nearly parallel: its condition number is 1e10.
TEST(ExtremePrograms, RowsAllButParallel) {
  constexpr int kSize = 8;
  lp::LinearProgram program;
  for (int j = 0; j < kSize; ++j) program.add_column(1, 0, 10);
  for (int r = 0; r < kSize; ++r) {
    std::vector<Entry> row;
    double sum = 0;
    for (int j = 0; j < kSize; ++j) {
      row.push_back({j, 1.0 / (1 + r + j)});
      sum += row.back().value;
    }
    program.add_row(row, sum);
  }
  Worst worst;
  worst.include(program);
  worst.expect_closed();
}

TEST(ExtremePrograms, ColumnsThatNothingHolds) {
  Worst worst;
  lp::LinearProgram program = row_of_points(50, 10);
  for (int k = 0; k < 1000;
       ++k) {  // free columns without cost: some occur in no row, some in a row that is never active
    const int loose = program.add_column(0, -lp::kInfinity, lp::kInfinity);
    if (k % 2 == 0) program.add_row(std::vector<Entry>{{loose, 1}, {k % 50, 1}}, -1);
  }
  worst.include(program);
  worst.expect_closed();
}

// Rows scaled by different units, from a thousandth to a thousand: more than occurs in any of our models.
TEST(ExtremePrograms, RowsInUnitsAMillionApart) {
  Random random{3};
  Worst worst;
  for (const int points : {5, 20}) {
    lp::LinearProgram program = lp::compaction_program({.points = points});
    for (int r = 0; r < program.rows(); ++r) {
      const double unit = std::pow(10.0, static_cast<double>(random.between(-3, 3)));
      const auto k = static_cast<std::size_t>(r);
      program.bound[k] *= unit;
      for (std::size_t e = program.row_start[k]; e < program.row_start[k + 1]; ++e) program.entries[e].value *= unit;
    }
    worst.include(program, 100);
  }
  worst.expect_closed();
}

// 50,000 half-spaces around a ball in 12 dimensions.
TEST(ExtremePrograms, FiftyThousandRows) {
  Random random{4};
  constexpr int kColumns = 12;
  lp::LinearProgram program;
  for (int j = 0; j < kColumns; ++j) program.add_column(random.part() * 2 - 1, -lp::kInfinity, lp::kInfinity);
  for (int r = 0; r < 50'000; ++r) {
    std::vector<Entry> row;
    double square = 0;
    for (int j = 0; j < kColumns; ++j) {
      row.push_back({j, random.part() * 2 - 1});
      square += row.back().value * row.back().value;
    }
    for (Entry& entry : row) entry.value /= std::sqrt(square);
    program.add_row(row, -1);
  }
  Worst worst;
  worst.include(program);
  reached("rows", program.rows());
  worst.expect_closed();
}

// As many rows with the structure of a compaction step.  Simplex needs 40,000 pivots and a minute for the same
// objective, so it is not run here: primal feasibility, dual feasibility and the duality gap prove optimality without
// it.
TEST(ExtremePrograms, FiftyThousandRowsOfACompaction) {
  const lp::LinearProgram program = lp::compaction_program({.points = 3300});
  ASSERT_GE(program.rows(), 50'000);
  const lp::LpSolution solution = lp::interior_point::solve_by_interior_point(program);
  ASSERT_EQ(solution.status, lp::LpStatus::kOptimal);
  const ExactCertificate exact = exact_certificate(program, solution);
  const double gap = std::abs(exact.gap / exact.objective);
  reached("rows", program.rows());
  reached("row broken by", exact.primal);
  reached("price beyond its bound", exact.dual);
  reached("gap over objective", gap);
  EXPECT_LE(exact.primal, 1e-9);
  EXPECT_LE(exact.dual, 1e-8);
  EXPECT_LE(gap, 1e-6);
  EXPECT_NEAR(exact.objective, -744.957022733, 1e-6);  // the objective found by simplex
}

}  // namespace
}  // namespace selvage::test
