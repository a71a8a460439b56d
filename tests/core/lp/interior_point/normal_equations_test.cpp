// The normal equations compared entry by entry with the rows that they are made of, on programs with the structure of a
// compaction step and on irregular rows.
#include "core/lp/interior_point/normal_equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/lp/interior_point/block_cholesky.h"
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
      normal.solve(x);
      EXPECT_EQ(x.back(), 5);
      x.pop_back();
      auto forces = product(*form, x);
      for (std::size_t r = 0; r < forces.size(); ++r) forces[r] *= weight[r];
      const auto left_side = transposed_product(*form, forces);
      for (std::size_t j = 0; j < x.size(); ++j) EXPECT_NEAR(left_side[j] + rho * x[j], right_side[j], 1e-9);
    }
  }
}

TEST(BlockCholesky, RejectsIndefiniteMatricesAndStaysUsable) {
  BlockPattern pattern;
  pattern.start = {0, 0, 1};
  pattern.row = {0};
  BlockCholesky factor{pattern};
  const Block one = Block::Identity();
  const std::vector<Block> above{one};
  EXPECT_FALSE(factor.factorise(std::vector<Block>{one, one}, above));                    // singular
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{1, 0}, {2, 1}}, one}, above));  // indefinite within a block
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{-1, 0}, {0, 1}}, one}, above));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factor.factorise(std::vector<Block>{Block{{nan, 0}, {0, 1}}, one}, above));
  ASSERT_TRUE(factor.factorise(std::vector<Block>{one, 2 * one}, above));
  std::vector<double> v{3, 4, 5, 6};  // (1 1; 1 2) (x; y) in both blocks
  factor.solve(v);
  EXPECT_NEAR(v[0], 1, 1e-14);
  EXPECT_NEAR(v[1], 2, 1e-14);
  EXPECT_NEAR(v[2], 2, 1e-14);
  EXPECT_NEAR(v[3], 2, 1e-14);
}

// A full matrix of `size` block columns: 4 times the unit matrix in every block on the diagonal, a little elsewhere.
struct FullMatrix {
  BlockPattern pattern;
  std::vector<Block> diagonal, above;
};
FullMatrix full_matrix(int size) {
  FullMatrix full;
  for (int k = 0; k < size; ++k) {
    for (int i = 0; i < k; ++i) full.pattern.row.push_back(i);
    full.pattern.start.push_back(static_cast<int>(full.pattern.row.size()));
    full.diagonal.emplace_back(4 * Block::Identity());
  }
  full.above.assign(full.pattern.row.size(), 1e-3 * Block::Identity());
  return full;
}

TEST(BlockCholesky, StopsWithinTheWorkBetweenTwoChecks) {
  constexpr int kSize = 300;  // 4.5 million block updates
  const FullMatrix full = full_matrix(kSize);
  BlockCholesky factor{full.pattern};
  ASSERT_TRUE(factor.factorise(full.diagonal, full.above));
  EXPECT_GT(factor.updates(), 4 * BlockCholesky::kUpdatesPerCheck);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(factor.factorise(full.diagonal, full.above, stop.get_token()));
  EXPECT_LE(factor.updates(), BlockCholesky::kUpdatesPerCheck + kSize * kSize / 2);  // and the longest row
  ASSERT_TRUE(factor.factorise(full.diagonal, full.above));
}

}  // namespace
}  // namespace selvage::lp::interior_point
