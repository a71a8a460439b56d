#include "tests/extremes/certificates/exact_equations.h"

#include <algorithm>
#include <utility>

namespace selvage::test {
namespace {

using Coefficients = std::map<std::size_t, Rational>;

// The unknown that an equation is solved for: the one with the largest weight, which changes by the smallest fraction
// of itself.
std::size_t heaviest(const Coefficients& coefficients, const std::vector<Rational>& near) {
  const auto weight = [&](const auto& term) {
    return std::pair{Rational{abs(term.second * near[term.first])}, Rational{abs(term.second)}};
  };
  const auto lighter = [&](const auto& a, const auto& b) { return weight(a) < weight(b); };
  return std::max_element(coefficients.begin(), coefficients.end(), lighter)->first;
}

// Eliminates `unknown` from `equation`, using another equation that contains it.
void eliminate(Equation& equation, const Equation& with, std::size_t unknown) {
  const auto found = equation.coefficients.find(unknown);
  if (found == equation.coefficients.end()) return;
  const Rational factor = found->second / with.coefficients.at(unknown);
  for (const auto& [other, coefficient] : with.coefficients) {
    Rational& changed = equation.coefficients[other];
    changed -= factor * coefficient;
    if (changed == 0) equation.coefficients.erase(other);
  }
  equation.right -= factor * with.right;
}

}  // namespace

std::vector<Rational> exact_solution(std::vector<Equation> equations, std::vector<Rational> near) {
  std::vector<std::pair<std::size_t, Equation>>
      settled;  // no equation contains an unknown that an earlier one is solved for
  for (Equation& equation : equations) {
    for (const auto& [unknown, with] : settled) eliminate(equation, with, unknown);
    if (equation.coefficients.empty()) continue;
    const std::size_t unknown = heaviest(equation.coefficients, near);
    settled.emplace_back(unknown, std::move(equation));
  }
  for (auto it = settled.rbegin(); it != settled.rend(); ++it) {
    const auto& [unknown, equation] = *it;
    Rational rest = equation.right;
    for (const auto& [other, coefficient] : equation.coefficients) {
      if (other != unknown) rest -= coefficient * near[other];
    }
    near[unknown] = rest / equation.coefficients.at(unknown);
  }
  return near;
}

}  // namespace selvage::test
