#include "core/lp/linear_program.h"

#include <algorithm>

namespace selvage::lp {

double infeasibility(const LinearProgram& program, std::span<const double> x) {
  double worst = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    worst = std::max({worst, program.lower[j] - x[j], x[j] - program.upper[j]});
  }
  for (int r = 0; r < program.rows(); ++r) {
    double activity = 0;
    for (const auto& [column, value] : program.row(r)) activity += value * x[static_cast<std::size_t>(column)];
    worst = std::max(worst, program.bound[static_cast<std::size_t>(r)] - activity);
  }
  return worst;
}

}  // namespace selvage::lp
