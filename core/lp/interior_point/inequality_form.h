// The form of a linear program that the interior point method works on: minimise cost . x subject to A x >= bound, x
// free.
//
// Fixed columns are substituted, each finite column bound becomes a row with one entry after all other rows, and empty
// rows are checked and dropped.  A is stored row by row.
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
  std::vector<int> program_column;  // the program's column of each column
  std::vector<int> program_row;     // the program's row of each row; kColumnBound for a column bound

  static constexpr int kColumnBound = -1;

  [[nodiscard]] int columns() const { return static_cast<int>(cost.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(bound.size()); }
  // Frees the rows' entries, which take more memory than all else.
  void drop_matrix() {
    row_start = column = std::vector<int>{};
    value = std::vector<double>{};
  }
};

// Nothing when an empty row requires more than `tolerance`: the program is infeasible.
[[nodiscard]] std::optional<InequalityForm> inequality_form(const LinearProgram& program, double tolerance);

}  // namespace selvage::lp::interior_point
