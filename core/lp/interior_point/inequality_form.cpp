#include "core/lp/interior_point/inequality_form.h"

#include <algorithm>

namespace selvage::lp::interior_point {
namespace {

constexpr int kFixed = -1;

void add_column_bound(InequalityForm& form, int column, double sign, double bound) {
  form.column.push_back(column);
  form.value.push_back(sign);
  form.row_start.push_back(static_cast<int>(form.column.size()));
  form.bound.push_back(sign * bound);
  form.program_row.push_back(InequalityForm::kColumnBound);
}

// The form's column for each column of the program; kFixed for columns that cannot move.
std::vector<int> add_columns(InequalityForm& form, const LinearProgram& program) {
  std::vector<int> column_of(program.cost.size(), kFixed);
  for (std::size_t j = 0; j < column_of.size(); ++j) {
    if (program.lower[j] == program.upper[j]) continue;
    column_of[j] = form.columns();
    form.cost.push_back(program.cost[j]);
    form.program_column.push_back(static_cast<int>(j));
  }
  return column_of;
}

}  // namespace

std::optional<InequalityForm> inequality_form(const LinearProgram& program, double tolerance) {
  InequalityForm form;
  const std::vector<int> column_of = add_columns(form, program);
  form.column.reserve(program.entries.size() + 2 * form.cost.size());
  form.value.reserve(form.column.capacity());
  form.row_start.push_back(0);
  for (int r = 0; r < program.rows(); ++r) {
    double bound = program.bound[static_cast<std::size_t>(r)];
    for (const auto& [column, value] : program.row(r)) {
      const auto j = static_cast<std::size_t>(column);
      if (column_of[j] == kFixed) {
        bound -= value * program.lower[j];
      } else if (value != 0) {
        form.column.push_back(column_of[j]);
        form.value.push_back(value);
      }
    }
    const bool empty = static_cast<int>(form.column.size()) == form.row_start.back();
    if (empty && bound > tolerance) return std::nullopt;
    if (empty || bound == -kInfinity) {
      form.column.resize(static_cast<std::size_t>(form.row_start.back()));
      form.value.resize(form.column.size());
      continue;
    }
    form.row_start.push_back(static_cast<int>(form.column.size()));
    form.bound.push_back(bound);
    form.program_row.push_back(r);
  }
  for (int k = 0; k < form.columns(); ++k) {
    const auto j = static_cast<std::size_t>(form.program_column[static_cast<std::size_t>(k)]);
    if (program.lower[j] != -kInfinity) add_column_bound(form, k, 1, program.lower[j]);
    if (program.upper[j] != kInfinity) add_column_bound(form, k, -1, program.upper[j]);
  }
  return form;
}

}  // namespace selvage::lp::interior_point
