// The form the interior point method works on: minimise cost . x subject to A x >= bound, x free.
//
// Columns that cannot move are substituted away, finite column bounds become rows of one entry, and empty rows are
// dropped once checked.  A is stored row by row.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/lp/linear_program.h"

namespace selvage {

struct InequalityForm {
  std::vector<double> cost;    // per column
  std::vector<double> bound;   // per row
  std::vector<int> row_start;  // rows() + 1 positions in `column` and `value`
  std::vector<int> column;
  std::vector<double> value;
  std::vector<int> program_column;  // where each column came from
  std::vector<int> program_row;     // where each row came from; kColumnBound for a column bound

  static constexpr int kColumnBound = -1;

  [[nodiscard]] int columns() const { return static_cast<int>(cost.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(bound.size()); }
};

// Nothing when an empty row asks for more than `tolerance`: the program is infeasible.
[[nodiscard]] std::optional<InequalityForm> inequality_form(const LinearProgram& program, double tolerance);

// Calls visit(std::integral_constant) with the row's number of entries where rows of position models have that many (a
// bound 1, along an axis 2, slanted 4), and visit(int) else: so that the usual loops over a row are unrolled.
template <class Visit>
void with_row_size(const InequalityForm& form, std::size_t row, const Visit& visit) {
  const int size = form.row_start[row + 1] - form.row_start[row];
  switch (size) {
    case 1: return visit(std::integral_constant<int, 1>{});
    case 2: return visit(std::integral_constant<int, 2>{});
    case 4: return visit(std::integral_constant<int, 4>{});
    default: return visit(size);
  }
}

// result = A x.
void multiply(const InequalityForm& form, std::span<const double> x, std::span<double> result);
// result = A^T y.
void multiply_transposed(const InequalityForm& form, std::span<const double> y, std::span<double> result);

}  // namespace selvage
