#include "core/lp/certificate.h"

#include <algorithm>
#include <cmath>

namespace selvage::lp {

Certificate certificate_of(const LinearProgram& program, const LpSolution& solution) {
  Certificate found{.primal = infeasibility(program, solution.x)};
  std::vector<double> reduced = program.cost;  // the reduced cost of each column
  double proved = 0;
  for (int r = 0; r < program.rows(); ++r) {
    const double price = solution.dual[static_cast<std::size_t>(r)];
    if (price == 0) continue;  // skipped because the bound may be infinite
    found.dual = std::max(found.dual, -price);
    proved += price * program.bound[static_cast<std::size_t>(r)];
    for (const auto& [column, value] : program.row(r)) reduced[static_cast<std::size_t>(column)] -= price * value;
  }
  double objective = 0;
  for (std::size_t j = 0; j < reduced.size(); ++j) {
    objective += program.cost[j] * solution.x[j];
    const double bound = reduced[j] > 0 ? program.lower[j] : program.upper[j];
    if (std::isfinite(bound)) {
      proved += reduced[j] * bound;
    } else {
      found.dual = std::max(found.dual, std::abs(reduced[j]));
      proved += reduced[j] * solution.x[j];  // there is no bound: counted as a dual violation above, not as a gap
    }
  }
  found.gap = std::abs(objective - proved) / (1 + std::abs(objective));
  return found;
}

}  // namespace selvage::lp
