// The rows of an inequality form once more, laid out for the products that an interior point iteration is made of.
//
// A row of a position model is n . (d_q - d_p): two differences of columns, and all rows of a pair of pieces are made
// of the same two.  So rows are kept in runs that share their differences: a product with A takes these once, one with
// A^T sums up along the run before it touches a column, and A^T W A needs three sums of a run of any length [Li94 4.1.4
// has such rows; the layout is ours].  Any row fits: an entry without an opposite is its column's difference from
// `still`.
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
    int first_difference{}, width{};  // `width` differences
    int first_value{};                // row after row, `width` values each
  };

  // A row that is a column or, of an upper bound, its opposite.
  struct Bound {
    int column{};
    double sign{};
  };

  int columns{};  // of the form
  std::vector<Difference> differences;
  std::vector<double> value;
  std::vector<Run> runs;      // the form's rows in their order
  std::vector<Bound> bounds;  // and, after these, its column bounds, which are not worth a run each

  // The column past the form's, which is always 0.
  [[nodiscard]] int still() const { return columns; }
};
[[nodiscard]] RowRuns row_runs(const InequalityForm& form);

// In both, x has an entry per column and one more for the column that stays still: 0 in the first, of no meaning after
// the second.  result = A x:
void multiply(const RowRuns& rows, std::span<const double> x, std::span<double> result);
// result = A^T y:
void multiply_transposed(const RowRuns& rows, std::span<const double> y, std::span<double> result);

// Calls visit(std::integral_constant) with the widths that position models have (an axis or a bound 1, a slanted pair
// 2, a turn 3), and visit(int) else: so that the usual loops over a run are unrolled.
template <class Visit>
void with_width(const RowRuns::Run& run, const Visit& visit) {
  switch (run.width) {
    case 1: return visit(std::integral_constant<int, 1>{});
    case 2: return visit(std::integral_constant<int, 2>{});
    case 3: return visit(std::integral_constant<int, 3>{});
    default: return visit(run.width);
  }
}

// As many zeros as said.
template <int count>
[[nodiscard]] std::array<double, static_cast<std::size_t>(count)> zeros(std::integral_constant<int, count>) {
  return {};
}
[[nodiscard]] inline std::vector<double> zeros(int count) {
  return std::vector<double>(static_cast<std::size_t>(count));
}

// Calls visit(a, b, sum) for every two differences a <= b of a run, by their number in it, with the sum over the run's
// rows of weight times both their values: what A^T W A is made of.
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
