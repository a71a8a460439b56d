// A linear program as a value: minimise cost . x subject to lower <= x <= upper and row . x >= bound for every row.
//
// Rows are sparse.  Infinite bounds are +-kInfinity.  The position models are scaled so that the largest coefficient of
// every row is about 1 and x is of the order of 1; the tolerances of the solvers rely on that.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace selvage::lp {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct LinearProgram {
  struct Entry {
    int column{};
    double value{};
  };

  std::vector<double> cost, lower, upper;  // one per column
  std::vector<Entry> entries;              // the entries of all rows, row by row; no column occurs twice in a row
  std::vector<std::size_t> row_start{0};   // rows() + 1 positions in `entries`
  std::vector<double> bound;               // one per row

  [[nodiscard]] int columns() const { return static_cast<int>(cost.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(bound.size()); }
  [[nodiscard]] std::span<const Entry> row(int r) const {
    const auto k = static_cast<std::size_t>(r);
    return {entries.data() + row_start[k], row_start[k + 1] - row_start[k]};
  }
  int add_column(double column_cost, double low, double high) {
    cost.push_back(column_cost);
    lower.push_back(low);
    upper.push_back(high);
    return columns() - 1;
  }
  int add_row(std::span<const Entry> row_entries, double row_bound) {
    entries.insert(entries.end(), row_entries.begin(), row_entries.end());
    row_start.push_back(entries.size());
    bound.push_back(row_bound);
    return rows() - 1;
  }
};

enum class LpStatus { kOptimal, kInfeasible, kUnbounded, kWorkLimit, kStopped, kFailed };

struct LpSolution {
  LpStatus status{LpStatus::kFailed};
  std::vector<double> x{};  // one per column; valid when the status is kOptimal
  std::vector<double>
      dual{};  // one per row, >= 0: the rate at which the objective falls when the row's bound is lowered
  double objective{};
  int iterations{};
};

// The largest violation of a row or a column bound by x; 0 when x is feasible.
[[nodiscard]] double infeasibility(const LinearProgram& program, std::span<const double> x);

}  // namespace selvage::lp
