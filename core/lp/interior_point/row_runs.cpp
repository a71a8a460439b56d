#include "core/lp/interior_point/row_runs.h"

#include <algorithm>

#include <Eigen/Core>

namespace selvage::lp::interior_point {
namespace {

using Difference = RowRuns::Difference;

struct Term {
  Difference of;
  double value{};
};

constexpr std::size_t kAhead = 3;  // how many of the next entries are searched for an opposite one

// The entries of a row, with pairs of opposite values combined into differences.
void terms_of(const InequalityForm& form, std::size_t row, int zero_column, std::vector<Term>& terms) {
  terms.clear();
  const auto begin = static_cast<std::size_t>(form.row_start[row]);
  const auto end = static_cast<std::size_t>(form.row_start[row + 1]);
  std::size_t taken = 0;  // a bit for each of the next entries, set once it has been combined
  for (std::size_t k = begin; k < end; ++k, taken >>= 1) {
    if ((taken & 1) != 0) continue;
    std::size_t other = k + 1;
    while (other < std::min(end, k + 1 + kAhead) &&
           (form.value[other] != -form.value[k] || (taken >> (other - k) & 1) != 0)) {
      ++other;
    }
    const bool opposite = other < std::min(end, k + 1 + kAhead);
    if (opposite) taken |= std::size_t{1} << (other - k);
    terms.push_back({{form.column[k], opposite ? form.column[other] : zero_column}, form.value[k]});
  }
}

// Builds a run row by row.
class RunBuilder {
 public:
  RunBuilder(RowRuns& rows, std::vector<Difference>& differences) : rows_{rows}, differences_{differences} {}

  // True when the run has rows and either the row's differences or the run's contain the other's.
  [[nodiscard]] bool accepts(const std::vector<Term>& terms) const {
    std::size_t shared = 0;
    for (const Term& term : terms) shared += place(term.of) < differences_.size();
    return !row_ends_.empty() && (shared == terms.size() || shared == differences_.size());
  }
  void add(const std::vector<Term>& terms) {
    for (const Term& term : terms) {
      if (place(term.of) == differences_.size()) differences_.push_back(term.of);
      terms_.push_back(term);
    }
    row_ends_.push_back(terms_.size());
  }
  void finish() {
    if (row_ends_.empty()) return;
    const std::size_t width = differences_.size();
    RowRuns::Run run{.rows = static_cast<int>(row_ends_.size()),
                     .first_difference = static_cast<int>(rows_.differences.size()),
                     .width = static_cast<int>(width),
                     .first_value = static_cast<int>(rows_.value.size())};
    if (!rows_.runs.empty()) run.first_row = rows_.runs.back().first_row + rows_.runs.back().rows;
    rows_.runs.push_back(run);
    rows_.differences.insert(rows_.differences.end(), differences_.begin(), differences_.end());
    rows_.value.resize(rows_.value.size() + width * row_ends_.size());
    double* value = rows_.value.data() + run.first_value;
    std::size_t k = 0;
    for (const std::size_t row_end : row_ends_) {
      for (; k < row_end; ++k) value[place(terms_[k].of)] = terms_[k].value;
      value += width;
    }
    differences_.clear();
    terms_.clear();
    row_ends_.clear();
  }

 private:
  [[nodiscard]] std::size_t place(const Difference& of) const {
    return static_cast<std::size_t>(std::find(differences_.begin(), differences_.end(), of) - differences_.begin());
  }

  RowRuns& rows_;
  std::vector<Difference>& differences_;
  std::vector<Term> terms_;  // of all rows of the run
  std::vector<std::size_t> row_ends_;
};

}  // namespace

RowRuns row_runs(const InequalityForm& form) {
  RowRuns rows;
  rows.columns = form.columns();
  rows.value.reserve(form.value.size());
  rows.differences.reserve(form.value.size());
  std::vector<Difference> differences;
  std::vector<Term> terms;
  RunBuilder run{rows, differences};
  std::size_t r = 0;
  for (; r < form.bound.size() && form.program_row[r] != InequalityForm::kColumnBound; ++r) {
    terms_of(form, r, rows.zero_column(), terms);
    if (!run.accepts(terms)) run.finish();
    run.add(terms);
  }
  run.finish();
  for (; r < form.bound.size(); ++r) {
    const auto k = static_cast<std::size_t>(form.row_start[r]);
    rows.bounds.push_back({form.column[k], form.value[k]});
  }
  return rows;
}

void multiply(const RowRuns& rows, std::span<const double> x, std::span<double> result) {
  double* out = result.data();
  for (const RowRuns::Run& run : rows.runs) {
    with_width(run, [&](auto width) {
      const Difference* of = rows.differences.data() + run.first_difference;
      auto difference = zeros(width);
      for (int k = 0; k < width; ++k) {
        const auto i = static_cast<std::size_t>(k);
        difference[i] = x[static_cast<std::size_t>(of[k].plus)] - x[static_cast<std::size_t>(of[k].minus)];
      }
      const double* value = rows.value.data() + run.first_value;
      for (int r = 0; r < run.rows; ++r, value += width) {
        double sum = value[0] * difference[0];
        for (int k = 1; k < width; ++k) sum += value[k] * difference[static_cast<std::size_t>(k)];
        *out++ = sum;
      }
    });
  }
  for (const auto& [column, sign] : rows.bounds) *out++ = sign * x[static_cast<std::size_t>(column)];
}

void multiply_transposed(const RowRuns& rows, std::span<const double> y, std::span<double> result) {
  std::fill(result.begin(), result.end(), 0.0);
  const double* in = y.data();
  for (const RowRuns::Run& run : rows.runs) {
    with_width(run, [&](auto width) {
      const Difference* of = rows.differences.data() + run.first_difference;
      const double* value = rows.value.data() + run.first_value;
      const auto add_force = [&](const Difference& at, double force) {
        result[static_cast<std::size_t>(at.plus)] += force;
        result[static_cast<std::size_t>(at.minus)] -= force;
      };
      if constexpr (std::is_same_v<decltype(width), std::integral_constant<int, 2>>) {
        Eigen::Array2d force = Eigen::Array2d::Zero();
        for (int r = 0; r < run.rows; ++r, value += 2) force += Eigen::Map<const Eigen::Array2d>{value} * in[r];
        add_force(of[0], force[0]);
        add_force(of[1], force[1]);
      } else {
        for (int k = 0; k < width; ++k) {
          double force = 0;
          for (int r = 0; r < run.rows; ++r) force += value[r * width + k] * in[r];
          add_force(of[k], force);
        }
      }
      in += run.rows;
    });
  }
  for (const auto& [column, sign] : rows.bounds) result[static_cast<std::size_t>(column)] += sign * *in++;
}

}  // namespace selvage::lp::interior_point
