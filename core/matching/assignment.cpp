#include "core/matching/assignment.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace selvage::matching {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// REQUIRES of the costs: no more rows than columns.
class AugmentingPaths {
 public:
  explicit AugmentingPaths(const Costs& costs)
      : costs_{costs},
        row_prices_(costs.rows()),
        column_prices_(costs.columns()),
        column_of_(costs.rows(), kNone),
        row_of_(costs.columns(), kNone),
        distance_(costs.columns()),
        before_(costs.columns()),
        done_(costs.columns()) {}

  Assignment solve(const std::stop_token& stop) {
    take_cheapest(stop);
    for (std::size_t row = 0; row < costs_.rows() && !stop.stop_requested(); ++row) {
      if (column_of_[row] == kNone) augment(row);
    }
    Assignment assignment{
        .column_of = {}, .cost = 0, .row_prices = std::move(row_prices_), .column_prices = std::move(column_prices_)};
    for (std::size_t row = 0; row < costs_.rows(); ++row) {
      auto& column = assignment.column_of.emplace_back();
      if (column_of_[row] == kNone) continue;  // it was cancelled
      column = column_of_[row];
      assignment.cost += costs_(row, column_of_[row]);
    }
    return assignment;
  }

 private:
  void match(std::size_t row, std::size_t column) {
    column_of_[row] = column;
    row_of_[column] = row;
  }

  void take_cheapest(const std::stop_token& stop) {
    for (std::size_t row = 0; row < costs_.rows() && !stop.stop_requested(); ++row) {
      std::size_t cheapest = 0;
      for (std::size_t column = 1; column < costs_.columns(); ++column) {
        if (costs_(row, column) < costs_(row, cheapest)) cheapest = column;
      }
      row_prices_[row] = costs_(row, cheapest);
      if (row_of_[cheapest] == kNone) match(row, cheapest);
    }
  }

  // The columns that a row reaches over a column at this distance, and the nearest one that is not done.
  std::size_t relax(std::size_t row, double distance) {
    std::size_t nearest = kNone;
    for (std::size_t column = 0; column < costs_.columns(); ++column) {
      if (done_[column] != 0) continue;
      const double reached = distance + costs_(row, column) - row_prices_[row] - column_prices_[column];
      if (reached < distance_[column]) {
        distance_[column] = reached;
        before_[column] = row;
      }
      const bool nearer = nearest == kNone || distance_[column] < distance_[nearest];
      const bool free_and_as_near =
          !nearer && distance_[column] == distance_[nearest] && row_of_[column] == kNone && row_of_[nearest] != kNone;
      if (nearer || free_and_as_near) nearest = column;
    }
    return nearest;
  }

  // Dijkstra's search from a free row to the nearest free column, over reduced costs.
  void augment(std::size_t start) {
    std::fill(distance_.begin(), distance_.end(), std::numeric_limits<double>::infinity());
    std::fill(done_.begin(), done_.end(), std::uint8_t{0});
    std::size_t row = start;
    std::size_t end = kNone;
    double distance = 0;
    while (end == kNone) {
      const std::size_t column = relax(row, distance);
      distance = distance_[column];
      done_[column] = 1;
      if (row_of_[column] == kNone) {
        end = column;
      } else {
        row = row_of_[column];
      }
    }
    update_prices(start, distance);
    for (std::size_t column = end; column != kNone;) {
      const std::size_t by = before_[column];
      const std::size_t next = column_of_[by];
      match(by, column);
      column = next;
    }
  }

  // Keeps all reduced costs at 0 or more, and those of the path at 0.
  void update_prices(std::size_t start, double distance) {
    row_prices_[start] += distance;
    for (std::size_t column = 0; column < costs_.columns(); ++column) {
      if (done_[column] == 0) continue;
      if (row_of_[column] != kNone) row_prices_[row_of_[column]] += distance - distance_[column];
      column_prices_[column] -= distance - distance_[column];
    }
  }

  const Costs& costs_;
  std::vector<double> row_prices_, column_prices_;
  std::vector<std::size_t> column_of_, row_of_;  // of the assignment so far
  std::vector<double> distance_;                 // of the columns from the row that is being added
  std::vector<std::size_t> before_;              // the row over which a column is reached
  std::vector<std::uint8_t> done_;               // columns whose distance is final
};

Costs transposed(const Costs& costs) {
  Costs other{costs.columns(), costs.rows()};
  for (std::size_t row = 0; row < costs.rows(); ++row) {
    for (std::size_t column = 0; column < costs.columns(); ++column) other(column, row) = costs(row, column);
  }
  return other;
}

}  // namespace

Assignment assign(const Costs& costs, const std::stop_token& stop) {
  if (costs.rows() == 0 || costs.columns() == 0) {
    return {.column_of = std::vector<std::optional<std::size_t>>(costs.rows()),
            .cost = 0,
            .row_prices = std::vector<double>(costs.rows()),
            .column_prices = std::vector<double>(costs.columns())};
  }
  if (costs.rows() <= costs.columns()) return AugmentingPaths{costs}.solve(stop);
  Assignment other = AugmentingPaths{transposed(costs)}.solve(stop);
  Assignment assignment{.column_of = std::vector<std::optional<std::size_t>>(costs.rows()),
                        .cost = other.cost,
                        .row_prices = std::move(other.column_prices),
                        .column_prices = std::move(other.row_prices)};
  for (std::size_t column = 0; column < costs.columns(); ++column) {
    if (other.column_of[column]) assignment.column_of[*other.column_of[column]] = column;
  }
  return assignment;
}

}  // namespace selvage::matching
