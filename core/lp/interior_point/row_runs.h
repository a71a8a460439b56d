// The rows of an inequality form, stored in a layout that makes the products of an interior point iteration fast.
//
// A row of a position model is n . (d_q - d_p), a combination of two differences of columns, and all rows of a pair of
// pieces use the same two differences.  Rows are therefore stored in runs that share their differences.  A product with
// A computes the differences once per run, a product with A^T sums over the run before it updates a column, and A^T W A
// needs three sums per run, however long it is.  [Li94 4.1.4] has such rows; the layout is our own.  Any row can be
// represented: an entry without an opposite is the difference between its column and the zero column.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "core/lp/interior_point/inequality_form.h"

namespace selvage::lp::interior_point {

struct RowRuns {
  struct Difference {
    int plus{}, minus{};  // x[plus] - x[minus]
    friend bool operator==(const Difference&, const Difference&) = default;
  };
  struct Run {
    int first_row{}, rows{};
    int first_difference{}, width{};  // the run has `width` differences
    int first_value{};                // row by row, `width` values each
  };

  // A row that bounds a single column: sign 1 for a lower bound, -1 for an upper bound.
  struct Bound {
    int column{};
    double sign{};
  };

  int columns{};  // number of columns of the form
  std::vector<Difference> differences;
  std::vector<double> value;
  std::vector<Run> runs;      // the rows of the form, in order
  std::vector<Bound> bounds;  // after the rows, the column bounds, which do not form runs

  // The index of the zero column: one past the last column of the form; its value is always 0.
  [[nodiscard]] int zero_column() const { return columns; }
};
[[nodiscard]] RowRuns row_runs(const InequalityForm& form);

// In both products, x has an entry per column and one more for the zero column, which must be 0 in multiply and has no
// meaning after multiply_transposed.
//
// result = A x:
void multiply(const RowRuns& rows, std::span<const double> x, std::span<double> result);
// result = A^T y:
void multiply_transposed(const RowRuns& rows, std::span<const double> y, std::span<double> result);

// Calls visit(std::integral_constant) for the widths that position models have (1: an axis or a bound, 2: a general
// pair, 3: a pair with rotation), and visit(int) for others, so that the common loops over a run are unrolled.
template <class Visit>
void with_width(const RowRuns::Run& run, const Visit& visit) {
  switch (run.width) {
    case 1: return visit(std::integral_constant<int, 1>{});
    case 2: return visit(std::integral_constant<int, 2>{});
    case 3: return visit(std::integral_constant<int, 3>{});
    default: return visit(run.width);
  }
}

// An array of `count` zeros.
template <int count>
[[nodiscard]] std::array<double, static_cast<std::size_t>(count)> zeros(std::integral_constant<int, count>) {
  return {};
}
[[nodiscard]] inline std::vector<double> zeros(int count) {
  return std::vector<double>(static_cast<std::size_t>(count));
}

// Calls visit(a, b, sum) for every two differences a <= b of a run, by their index within the run, where `sum` is the
// sum over the run's rows of weight times both values.  A^T W A is built from these sums.
template <class Visit>
void for_weighted_products(const RowRuns& rows, const RowRuns::Run& run, std::span<const double> weight,
                           const Visit& visit) {
  with_width(run, [&](auto width) {
    const double* w = weight.data() + run.first_row;
    const double* first = rows.value.data() + run.first_value;
    if constexpr (std::is_same_v<decltype(width), std::integral_constant<int, 2>>) {
      double xx = 0;
      double xy = 0;
      double yy = 0;
      for (int r = 0; r < run.rows; ++r, first += 2) {
        const double x = w[r] * first[0];
        const double y = w[r] * first[1];
        xx += x * first[0];
        xy += x * first[1];
        yy += y * first[1];
      }
      visit(0, 0, xx);
      visit(0, 1, xy);
      visit(1, 1, yy);
    } else {
      for (int a = 0; a < width; ++a) {
        for (int b = a; b < width; ++b) {
          double sum = 0;
          for (int r = 0; r < run.rows; ++r) sum += w[r] * first[r * width + a] * first[r * width + b];
          visit(a, b, sum);
        }
      }
    }
  });
}

}  // namespace selvage::lp::interior_point
