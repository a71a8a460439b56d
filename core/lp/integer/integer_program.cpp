#include "core/lp/integer/integer_program.h"

#include <algorithm>
#include <cmath>

namespace selvage::lp::integer {

bool is_solution(const IntegerProgram& program, std::span<const double> x, double tolerance) {
  if (x.size() != program.linear.cost.size() || infeasibility(program.linear, x) > tolerance) return false;
  return std::all_of(program.whole.begin(), program.whole.end(), [&](int column) {
    const double value = x[static_cast<std::size_t>(column)];
    return std::abs(value - std::round(value)) <= kWholeTolerance;
  });
}

double objective_of(const LinearProgram& program, std::span<const double> x) {
  double objective = 0;
  for (std::size_t k = 0; k < x.size(); ++k) objective += program.cost[k] * x[k];
  return objective;
}

}  // namespace selvage::lp::integer
