// The normal equations compared entry by entry with the rows that they are made of, on programs with the structure of a
// compaction step and on irregular rows.
#include "core/lp/interior_point/normal_equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>

#include "core/lp/interior_point/inequality_form.h"
#include "tests/core/lp/compaction_models.h"
#include "tests/support/random.h"

namespace selvage::lp::interior_point {
namespace {

using test::Random;

double real(Random& random, double low, double high) {
  return low + (high - low) * random.part();
}

// Rows of up to 7 entries in random order, some of which differ from the previous row by only one entry.
LinearProgram odd_rows(Random& random) {
  LinearProgram program;
  const auto columns = static_cast<int>(random.between(1, 12));
  for (int j = 0; j < columns; ++j) program.add_column(real(random, -1, 1), -1, j % 3 == 0 ? 1 : kInfinity);
  std::vector<LinearProgram::Entry> row;
  for (Coord r = random.between(0, 30); r > 0; --r) {
    if (random.chance(60)) row.clear();
    for (auto j = static_cast<int>(random.between(0, 1)); j < columns && row.size() < 7;
         j += static_cast<int>(random.between(1, 3))) {
      const bool held = std::any_of(row.begin(), row.end(), [&](const auto& entry) { return entry.column == j; });
      const double opposite = row.empty() ? 1 : -row.back().value;
      if (!held) row.push_back({j, random.chance(50) ? opposite : real(random, -1, 1)});
    }
    program.add_row(row, -1);
    if (!row.empty() && random.chance(50)) row.pop_back();
  }
  return program;
}

std::vector<LinearProgram> programs() {
  std::vector<LinearProgram> all;
  for (const int points : {1, 3, 50}) all.push_back(compaction_program({.points = points}));
  Random random{7};
  for (int k = 0; k < 200; ++k) all.push_back(odd_rows(random));
  return all;
}

std::vector<double> some(Random& random, int count, double low, double high) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(real(random, low, high));
  return values;
}

// A x and A^T y, computed from the form's entries.
std::vector<double> product(const InequalityForm& form, const std::vector<double>& x) {
  std::vector<double> result(form.bound.size());
  for (std::size_t r = 0; r < result.size(); ++r) {
    for (auto k = static_cast<std::size_t>(form.row_start[r]); k < static_cast<std::size_t>(form.row_start[r + 1]); ++k)
      result[r] += form.value[k] * x[static_cast<std::size_t>(form.column[k])];
  }
  return result;
}
std::vector<double> transposed_product(const InequalityForm& form, const std::vector<double>& y) {
  std::vector<double> result(form.cost.size());
  for (std::size_t r = 0; r < y.size(); ++r) {
    for (auto k = static_cast<std::size_t>(form.row_start[r]); k < static_cast<std::size_t>(form.row_start[r + 1]); ++k)
      result[static_cast<std::size_t>(form.column[k])] += form.value[k] * y[r];
  }
  return result;
}

TEST(RowRuns, MultiplyLikeTheOriginalEntries) {
  Random random{1};
  for (const LinearProgram& program : programs()) {
    const auto form = inequality_form(program, 1);
    ASSERT_TRUE(form);
    const RowRuns rows = row_runs(*form);
    auto x = some(random, form->columns(), -1, 1);
    const auto expected = product(*form, x);
    x.push_back(0);
    std::vector<double> result(form->bound.size());
    multiply(rows, x, result);
    for (std::size_t r = 0; r < result.size(); ++r) EXPECT_NEAR(result[r], expected[r], 1e-14);

    const auto y = some(random, form->rows(), -1, 1);
    const auto expected_back = transposed_product(*form, y);
    multiply_transposed(rows, y, x);
    for (std::size_t j = 0; j < expected_back.size(); ++j) EXPECT_NEAR(x[j], expected_back[j], 1e-13);
  }
}

TEST(RowRuns, CombineTheRowsOfAPair) {
  const auto form = inequality_form(compaction_program({.points = 2, .normals = 9}), 0);
  const RowRuns rows = row_runs(*form);
  ASSERT_FALSE(rows.runs.empty());
  EXPECT_EQ(rows.runs.front().rows, 9);
  EXPECT_EQ(rows.runs.front().width, 2);
}

TEST(RowRuns, CombineAnAxisRowWithTheOtherRowsOfItsPair) {
  LinearProgram program;
  for (int j = 0; j < 4; ++j) program.add_column(0, -kInfinity, kInfinity);
  using Row = std::vector<LinearProgram::Entry>;
  program.add_row(Row{{2, 1}, {0, -1}}, 0);
  program.add_row(Row{{2, 0.6}, {0, -0.6}, {3, 0.8}, {1, -0.8}}, 0);
  program.add_row(Row{{3, -1}, {1, 1}}, 0);
  const RowRuns rows = row_runs(*inequality_form(program, 0));
  ASSERT_EQ(rows.runs.size(), 1U);
  EXPECT_EQ(rows.value, (std::vector<double>{1, 0, 0.6, 0.8, 0, -1}));
}

TEST(NormalEquations, AreSolvedCorrectly) {
  Random random{2};
  for (const LinearProgram& program : programs()) {
    const auto form = inequality_form(program, 1);
    ASSERT_TRUE(form);
    const RowRuns rows = row_runs(*form);
    NormalEquations normal{rows};
    for (const double rho : {1e-3, 1.0}) {  // repeatedly with the same pattern
      const auto weight = some(random, form->rows(), 0.01, 10);
      ASSERT_TRUE(normal.factorise(weight, rho, {}));
      const auto right_side = some(random, form->columns(), -1, 1);
      auto x = right_side;
      x.push_back(5);  // the value of the zero column has no meaning
      normal.solve_lower(x);
      normal.solve_upper(x);
      EXPECT_EQ(x.back(), 5);
      x.pop_back();
      auto forces = product(*form, x);
      for (std::size_t r = 0; r < forces.size(); ++r) forces[r] *= weight[r];
      const auto left_side = transposed_product(*form, forces);
      for (std::size_t j = 0; j < x.size(); ++j) EXPECT_NEAR(left_side[j] + rho * x[j], right_side[j], 1e-9);
    }
  }
}

// With columns left: what remains of the matrix, solved, and the two halves of a solution give the whole solution.
TEST(NormalEquations, LeaveTheLastColumns) {
  Random random{3};
  for (const LinearProgram& program : programs()) {
    const auto form = inequality_form(program, 1);
    ASSERT_TRUE(form);
    const RowRuns rows = row_runs(*form);
    const auto weight = some(random, form->rows(), 0.01, 10);
    const int left = static_cast<int>(random.between(0, std::min(8, form->columns())));
    const int own = form->columns() - left;
    NormalEquations whole{rows};
    NormalEquations normal{rows, own};
    ASSERT_TRUE(whole.factorise(weight, 1e-2, {}));
    ASSERT_TRUE(normal.factorise(weight, 1e-2, {}));
    auto expected = some(random, form->columns(), -1, 1);
    expected.push_back(0);
    auto x = expected;
    whole.solve_lower(expected);
    whole.solve_upper(expected);
    normal.solve_lower(x);
    Eigen::MatrixXd matrix = 1e-2 * Eigen::MatrixXd::Identity(left, left);
    for (int i = 0; i < left; ++i) {
      for (int j = 0; j < left; ++j) {
        const double* entry = normal.remaining(own + i, own + j);
        if (entry != nullptr) matrix(i, j) += *entry;
      }
    }
    Eigen::Map<Eigen::VectorXd> last{x.data() + own, left};
    if (left > 0) last = matrix.llt().solve(last).eval();
    normal.solve_upper(x);
    for (std::size_t j = 0; j + 1 < x.size(); ++j) EXPECT_NEAR(x[j], expected[j], 1e-8);
  }
}

}  // namespace
}  // namespace selvage::lp::interior_point
