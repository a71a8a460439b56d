#include "core/lp/certificate.h"

#include <algorithm>
#include <cmath>

namespace selvage::lp {

Certificate certificate_of(const LinearProgram& program, const LpSolution& solution) {
  Certificate found{.primal = infeasibility(program, solution.x)};
  std::vector<double> reduced = program.cost;  // what a column costs once the rows' prices are paid
  double promised = 0;
  for (int r = 0; r < program.rows(); ++r) {
    const double price = solution.dual[static_cast<std::size_t>(r)];
    if (price == 0) continue;  // its bound may be infinite
    found.dual = std::max(found.dual, -price);
    promised += price * program.bound[static_cast<std::size_t>(r)];
    for (const auto& [column, value] : program.row(r)) reduced[static_cast<std::size_t>(column)] -= price * value;
  }
  double objective = 0;
  for (std::size_t j = 0; j < reduced.size(); ++j) {
    objective += program.cost[j] * solution.x[j];
    const double bound = reduced[j] > 0 ? program.lower[j] : program.upper[j];
    if (std::isfinite(bound)) {
      promised += reduced[j] * bound;
    } else {
      found.dual = std::max(found.dual, std::abs(reduced[j]));
      promised += reduced[j] * solution.x[j];  // nothing to rest on: counted above, not as a gap
    }
  }
  found.gap = std::abs(objective - promised) / (1 + std::abs(objective));
  return found;
}

}  // namespace selvage::lp
