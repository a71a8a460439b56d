// The form the interior point method works on: minimise cost . x subject to A x >= bound, x free.
//
// Columns that cannot move are substituted away, finite column bounds become rows of one entry after all others, and
// empty rows are dropped once checked.  A is stored row by row.
#pragma once

#include <optional>
#include <vector>

#include "core/lp/linear_program.h"

namespace selvage::lp::interior_point {

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

}  // namespace selvage::lp::interior_point
