#include "core/lp/solver/mend.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/lp/solver/solve.h"

namespace selvage::lp::solver {
namespace {

constexpr int kNone = -1;
// The cost of a unit by which broken rows give way, as a multiple of the largest cost: no row's price comes near it.
constexpr double kCostOfGiving = 1000;

std::size_t to_index(int i) {
  return static_cast<std::size_t>(i);
}

// The rows in which each column occurs.
class RowsOfColumns {
 public:
  explicit RowsOfColumns(const LinearProgram& program)
      : start_(program.cost.size() + 1), rows_(program.entries.size()) {
    for (const auto& entry : program.entries) ++start_[to_index(entry.column) + 1];
    for (std::size_t j = 1; j < start_.size(); ++j) start_[j] += start_[j - 1];
    std::vector<std::size_t> end(start_.begin(), start_.end() - 1);
    for (int r = 0; r < program.rows(); ++r) {
      for (const auto& entry : program.row(r)) rows_[end[to_index(entry.column)]++] = r;
    }
  }
  [[nodiscard]] std::span<const int> of(int column) const {
    const std::size_t j = to_index(column);
    return std::span{rows_}.subspan(start_[j], start_[j + 1] - start_[j]);
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<int> rows_;
};

class Mending {
 public:
  Mending(const LinearProgram& program, std::vector<double> x, const std::stop_token& stop)
      : program_{program},
        stop_{stop},
        allowed_{allowed_violation(program)},
        rows_{program},
        place_(program.cost.size(), kNone),
        x_{std::move(x)} {}

  [[nodiscard]] bool is_broken(int row) const { return shortfall(row) > allowed_; }
  // Changes x until it keeps the row, and still all rows that it kept before.
  [[nodiscard]] bool mend(int row);
  [[nodiscard]] std::vector<double> result() && { return std::move(x_); }

 private:
  // By how much x misses the row's bound.
  [[nodiscard]] double shortfall(int row) const {
    double sum = 0;
    for (const auto& [column, value] : program_.row(row)) sum += value * x_[to_index(column)];
    return program_.bound[to_index(row)] - sum;
  }
  void add_columns_of(int row);
  [[nodiscard]] bool grow();
  [[nodiscard]] std::vector<int> rows_of_part() const;
  [[nodiscard]] LinearProgram program_of_part(const std::vector<int>& rows) const;
  [[nodiscard]] bool solve_part();

  const LinearProgram& program_;
  const std::stop_token& stop_;
  const double allowed_;
  const RowsOfColumns rows_;
  std::size_t work_{};      // columns of all programs so far
  std::vector<int> part_;   // the columns that are solved for
  std::vector<int> place_;  // the index of each column in part_
  std::vector<double> x_;
};

bool Mending::mend(int row) {
  add_columns_of(row);
  bool done = false;
  do {
    work_ += part_.size();
    if (part_.size() > kMostMended || work_ > place_.size() || stop_.stop_requested()) break;
    done = solve_part();
  } while (!done && grow());
  for (const int j : part_) place_[to_index(j)] = kNone;
  part_.clear();
  return done;
}

void Mending::add_columns_of(int row) {
  for (const auto& entry : program_.row(row)) {
    const std::size_t j = to_index(entry.column);
    if (place_[j] != kNone || program_.lower[j] == program_.upper[j]) continue;
    place_[j] = static_cast<int>(part_.size());
    part_.push_back(entry.column);
  }
}

// Adds the columns that share a row with the part's.  False when there were none.
bool Mending::grow() {
  const std::size_t before = part_.size();
  for (const int row : rows_of_part()) add_columns_of(row);
  return part_.size() > before;
}

std::vector<int> Mending::rows_of_part() const {
  std::vector<int> rows;
  for (const int j : part_) {
    const auto of_column = rows_.of(j);
    rows.insert(rows.end(), of_column.begin(), of_column.end());
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

// The part's columns and one more, by which rows that are not kept now may be broken: so the program is always
// feasible.
LinearProgram Mending::program_of_part(const std::vector<int>& rows) const {
  double largest = 0;
  for (const int j : part_) largest = std::max(largest, std::abs(program_.cost[to_index(j)]));
  LinearProgram program;
  for (const int column : part_) {
    const std::size_t j = to_index(column);
    program.add_column(largest > 0 ? program_.cost[j] / largest : 0, program_.lower[j], program_.upper[j]);
  }
  const int give = program.add_column(kCostOfGiving, 0, kInfinity);
  std::vector<LinearProgram::Entry> entries;
  for (const int row : rows) {
    double bound = program_.bound[to_index(row)];
    entries.clear();
    for (const auto& [column, value] : program_.row(row)) {
      const int place = place_[to_index(column)];
      if (place != kNone) {
        entries.push_back({place, value});
      } else {
        bound -= value * x_[to_index(column)];
      }
    }
    if (shortfall(row) > 0) entries.push_back({give, 1});
    program.add_row(entries, bound);
  }
  return program;
}

bool Mending::solve_part() {
  const std::vector<int> rows = rows_of_part();
  const LpSolution solution = solve(program_of_part(rows), SolverChoice::kAutomatic, {}, stop_);
  if (solution.status != LpStatus::kOptimal) return false;
  std::vector<double> before;
  for (std::size_t k = 0; k < part_.size(); ++k) {
    before.push_back(std::exchange(x_[to_index(part_[k])], solution.x[k]));
  }
  if (std::none_of(rows.begin(), rows.end(), [&](int row) { return is_broken(row); })) return true;
  for (std::size_t k = 0; k < part_.size(); ++k) x_[to_index(part_[k])] = before[k];
  return false;
}

}  // namespace

std::optional<std::vector<double>> mended(const LinearProgram& program, std::vector<double> x,
                                          const std::stop_token& stop) {
  Mending mending{program, std::move(x), stop};
  for (int row = 0; row < program.rows(); ++row) {
    if (mending.is_broken(row) && !mending.mend(row)) return std::nullopt;
  }
  return std::move(mending).result();
}

}  // namespace selvage::lp::solver
