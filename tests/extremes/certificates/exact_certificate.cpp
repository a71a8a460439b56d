#include "tests/extremes/certificates/exact_certificate.h"

#include <algorithm>
#include <cmath>

namespace selvage::test {

Rational broken_by(const lp::LinearProgram& program, const std::vector<Rational>& x) {
  Rational worst = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (std::isfinite(program.lower[j])) worst = std::max<Rational>(worst, Rational{program.lower[j]} - x[j]);
    if (std::isfinite(program.upper[j])) worst = std::max<Rational>(worst, x[j] - Rational{program.upper[j]});
  }
  for (int r = 0; r < program.rows(); ++r) {
    const double bound = program.bound[static_cast<std::size_t>(r)];
    if (!std::isfinite(bound)) continue;
    Rational missing{bound};
    for (const auto& [column, value] : program.row(r)) missing -= Rational{value} * x[static_cast<std::size_t>(column)];
    worst = std::max(worst, missing);
  }
  return worst;
}

ExactCertificate exact_certificate(const lp::LinearProgram& program, const lp::LpSolution& solution) {
  const std::vector<Rational> x(solution.x.begin(), solution.x.end());
  std::vector<Rational> reduced(program.cost.begin(), program.cost.end());
  Rational promised = 0;
  Rational dual = 0;
  for (int r = 0; r < program.rows(); ++r) {
    const Rational price{solution.dual[static_cast<std::size_t>(r)]};
    if (price == 0) continue;
    dual = std::max<Rational>(dual, -price);
    promised += price * Rational{program.bound[static_cast<std::size_t>(r)]};
    for (const auto& [column, value] : program.row(r)) {
      reduced[static_cast<std::size_t>(column)] -= price * Rational{value};
    }
  }
  Rational objective = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    objective += Rational{program.cost[j]} * x[j];
    const double bound = reduced[j] > 0 ? program.lower[j] : program.upper[j];
    if (std::isfinite(bound)) {
      promised += reduced[j] * Rational{bound};
    } else {
      dual = std::max<Rational>(dual, abs(reduced[j]));
    }
  }
  const Rational gap = objective - promised;
  return {.primal = broken_by(program, x).convert_to<double>(),
          .dual = dual.convert_to<double>(),
          .objective = objective.convert_to<double>(),
          .gap = gap.convert_to<double>()};
}

}  // namespace selvage::test
