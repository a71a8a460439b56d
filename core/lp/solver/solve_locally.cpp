#include "core/lp/solver/solve_locally.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "core/lp/solver/solve.h"

namespace selvage::lp::solver {
namespace {

constexpr int kNone = -1;
// The rows that threads share at a time.  When one of them finds no room, the work on the others is wasted.
constexpr std::size_t kRowsAtOnce = 4;
// The cost of a unit by which broken rows give way, as a multiple of the largest cost: no row's price comes near it.
constexpr double kCostOfGiving = 1000;

std::size_t to_index(int i) {
  return static_cast<std::size_t>(i);
}

// By how much x misses the row's bound.
double shortfall(const LinearProgram& program, std::span<const double> x, int row) {
  double left = program.bound[to_index(row)];
  for (const auto& [column, value] : program.row(row)) left -= value * x[to_index(column)];
  return left;
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
  // The rows of all these columns, ascending.
  [[nodiscard]] std::vector<int> of(const std::vector<int>& columns) const {
    std::vector<int> rows;
    for (const int column : columns) {
      const std::size_t j = to_index(column);
      rows.insert(rows.end(), rows_.begin() + static_cast<std::ptrdiff_t>(start_[j]),
                  rows_.begin() + static_cast<std::ptrdiff_t>(start_[j + 1]));
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<int> rows_;
};

// Values for a few columns with which x keeps all of their rows.
struct Change {
  std::vector<int> columns;
  std::vector<double> values;  // empty: none were found
  std::size_t work{};          // the columns of all programs that were solved for this
};

// A few columns of a program, which are solved for while all others keep their values.
class Part {
 public:
  Part(const LinearProgram& program, const RowsOfColumns& rows_of, std::span<const double> x)
      : program_{program}, rows_of_{rows_of}, x_{x}, place_(program.cost.size(), kNone) {}

  void add_columns_of(int row);
  // Adds the columns that share a row with the part's.  False when there were none.
  bool grow();
  [[nodiscard]] const std::vector<int>& columns() const { return columns_; }
  // Nothing when no values keep all rows of the part's columns.
  [[nodiscard]] std::vector<double> solved(double allowed, const std::stop_token& stop) const;

 private:
  [[nodiscard]] LinearProgram program_of(const std::vector<int>& rows) const;

  const LinearProgram& program_;
  const RowsOfColumns& rows_of_;
  std::span<const double> x_;
  std::vector<int> columns_;
  std::vector<int> place_;  // the index of each of the program's columns in columns_
};

void Part::add_columns_of(int row) {
  for (const auto& entry : program_.row(row)) {
    const std::size_t j = to_index(entry.column);
    if (place_[j] != kNone || program_.lower[j] == program_.upper[j]) continue;
    place_[j] = static_cast<int>(columns_.size());
    columns_.push_back(entry.column);
  }
}

bool Part::grow() {
  const std::size_t before = columns_.size();
  for (const int row : rows_of_.of(columns_)) add_columns_of(row);
  return columns_.size() > before;
}

// The part's columns and, last, one by which rows that are not kept now may be broken: so the program is always
// feasible.
LinearProgram Part::program_of(const std::vector<int>& rows) const {
  double largest = 0;
  for (const int j : columns_) largest = std::max(largest, std::abs(program_.cost[to_index(j)]));
  LinearProgram program;
  for (const int column : columns_) {
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
    if (shortfall(program_, x_, row) > 0) entries.push_back({give, 1});
    program.add_row(entries, bound);
  }
  return program;
}

std::vector<double> Part::solved(double allowed, const std::stop_token& stop) const {
  LinearProgram program = program_of(rows_of_.of(columns_));
  LpSolution solution = solve(program, SolverChoice::kAutomatic, {}, stop);
  if (solution.status != LpStatus::kOptimal) return {};
  solution.x.back() = 0;
  if (infeasibility(program, solution.x) > allowed) return {};
  solution.x.pop_back();
  return std::move(solution.x);
}

class LocalSolution {
 public:
  LocalSolution(const LinearProgram& program, std::vector<double> x, const std::stop_token& stop)
      : program_{program}, stop_{stop}, rows_of_{program}, allowed_{allowed_violation(program)}, x_{std::move(x)} {}

  [[nodiscard]] bool is_broken(int row) const { return shortfall(program_, x_, row) > allowed_; }
  // With which x keeps the row, and still all rows that it keeps now.
  [[nodiscard]] Change change_around(int row) const;
  // False, and nothing changes, when x would break a row then, because of changes that were made since this one was
  // found.
  bool make(const Change& change);
  [[nodiscard]] std::vector<double> result() && { return std::move(x_); }

 private:
  const LinearProgram& program_;
  const std::stop_token& stop_;
  const RowsOfColumns rows_of_;
  const double allowed_;
  std::vector<double> x_;
};

Change LocalSolution::change_around(int row) const {
  Part part{program_, rows_of_, x_};
  part.add_columns_of(row);
  Change change;
  do {
    if (part.columns().size() > kMostLocalColumns || stop_.stop_requested()) break;
    change.work += part.columns().size();
    change.values = part.solved(allowed_, stop_);
  } while (change.values.empty() && part.grow());
  change.columns = part.columns();
  return change;
}

bool LocalSolution::make(const Change& change) {
  std::vector<double> before;
  for (std::size_t k = 0; k < change.columns.size(); ++k) {
    before.push_back(std::exchange(x_[to_index(change.columns[k])], change.values[k]));
  }
  const std::vector<int> rows = rows_of_.of(change.columns);
  if (std::none_of(rows.begin(), rows.end(), [&](int row) { return is_broken(row); })) return true;
  for (std::size_t k = 0; k < change.columns.size(); ++k) x_[to_index(change.columns[k])] = before[k];
  return false;
}

// The first of these rows, and later ones that share no column with those before them: kRowsAtOnce at most.
std::vector<int> without_shared_columns(const LinearProgram& program, const std::vector<int>& rows) {
  std::vector<char> taken(program.cost.size());
  std::vector<int> apart;
  for (const int row : rows) {
    if (apart.size() == kRowsAtOnce) break;
    const auto entries = program.row(row);
    const auto is_taken = [&](const auto& entry) { return taken[to_index(entry.column)] != 0; };
    if (std::any_of(entries.begin(), entries.end(), is_taken)) continue;
    for (const auto& entry : entries) taken[to_index(entry.column)] = 1;
    apart.push_back(row);
  }
  return apart;
}

}  // namespace

std::optional<std::vector<double>> solved_locally(const LinearProgram& program, std::vector<double> x,
                                                  const std::stop_token& stop, const Executor& executor) {
  LocalSolution local{program, std::move(x), stop};
  std::vector<int> broken(to_index(program.rows()));
  std::iota(broken.begin(), broken.end(), 0);
  const auto keep_broken = [&] { std::erase_if(broken, [&](int row) { return !local.is_broken(row); }); };
  std::size_t work = 0;
  for (keep_broken(); !broken.empty(); keep_broken()) {
    const std::vector<int> rows = without_shared_columns(program, broken);
    std::vector<Change> changes(rows.size());
    executor.for_each(rows.size(), [&](std::size_t k) { changes[k] = local.change_around(rows[k]); });
    bool changed = false;
    for (const Change& change : changes) {
      work += change.work;
      if (change.values.empty() || work > program.cost.size()) return std::nullopt;
      changed = local.make(change) || changed;
    }
    if (!changed) return std::nullopt;
  }
  return std::move(local).result();
}

}  // namespace selvage::lp::solver
