// The linear assignment problem: every row gets a column of its own, or every column a row where there are fewer
// columns, so that the sum of the costs is least.
//
// Method.  Rows whose cheapest column is free take it; each of the others is added by a shortest augmenting path with
// dual prices ([JV87], for rectangular costs as in [Cro16]).  The work is at most proportional to rows^2 times columns.
// Laws.  (1) The assignment is optimal but for rounding: with the prices, no cost is below the sum of its row's and
// its column's price, every assigned cost equals that sum, and a column without a row has price 0 (where there are
// more rows than columns: a row without a column).
// (2) Deterministic; of equal columns the first is preferred.
// Units: those of the costs.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace selvage::matching {

// A matrix, row after row.
class Costs {
 public:
  Costs(std::size_t rows, std::size_t columns) : rows_{rows}, columns_{columns}, values_(rows * columns) {}

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double& operator()(std::size_t row, std::size_t column) { return values_[row * columns_ + column]; }
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }

 private:
  std::size_t rows_, columns_;
  std::vector<double> values_;
};

struct Assignment {
  std::vector<std::optional<std::size_t>> column_of;  // by row
  double cost{};                                      // the sum of the assigned costs
  std::vector<double> row_prices, column_prices;
};

// When cancelled, rows may lack the column that they would get: a caller that may be cancelled looks at the token
// afterwards.
// REQUIRES: all costs are finite.
[[nodiscard]] Assignment assign(const Costs& costs, const std::stop_token& stop = {});

}  // namespace selvage::matching
