#include "tests/extremes/certificates/refutation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/extremes/certificates/exact_certificate.h"
#include "tests/extremes/certificates/exact_equations.h"

namespace selvage::test {
namespace {

// The largest value that a solver may leave in place of zero; all quantities are of the order of 1.
constexpr double kNoise = 1e-7;

// True for a sum that such values can add up to.
bool is_noise(const Rational& sum) {
  return abs(sum) <= 100 * kNoise;
}

// The values scaled so that the largest is 1, with noise and negative values replaced by zero.
std::vector<Rational> as_prices(std::span<const double> values) {
  const double largest = *std::max_element(values.begin(), values.end());
  std::vector<Rational> prices;
  for (const double value : values) prices.emplace_back(value > kNoise * largest ? value / largest : 0);
  return prices;
}

// For each column: the sum of the rows weighted with these prices.
std::vector<Equation> priced_columns(const lp::LinearProgram& program, const std::vector<Rational>& prices) {
  std::vector<Equation> columns(program.cost.size());
  for (int r = 0; r < program.rows(); ++r) {
    const auto k = static_cast<std::size_t>(r);
    if (prices[k] == 0) continue;
    for (const auto& [column, value] : program.row(r)) {
      if (value != 0) columns[static_cast<std::size_t>(column)].coefficients.emplace(k, value);
    }
  }
  return columns;
}
Rational sum(const Equation& equation, const std::vector<Rational>& values) {
  Rational total = 0;
  for (const auto& [unknown, coefficient] : equation.coefficients) total += coefficient * values[unknown];
  return total;
}

// The sum must be exactly zero in columns that are unbounded in the direction concerned.
std::vector<Rational> exact_prices(const lp::LinearProgram& program, std::span<const double> suggested) {
  std::vector<Rational> prices = as_prices(suggested);
  std::vector<Equation> nothing;
  const std::vector<Equation> columns = priced_columns(program, prices);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const bool endless = std::isinf(program.lower[j]) || std::isinf(program.upper[j]);
    if (endless && is_noise(sum(columns[j], prices))) nothing.push_back(columns[j]);
  }
  return exact_solution(std::move(nothing), std::move(prices));
}

// An exact point near one that violates no row by more than noise: values within noise of a bound are moved onto it.
std::vector<Rational> exact_point(const lp::LinearProgram& program, std::vector<Rational> point) {
  std::vector<Equation> met;
  for (std::size_t j = 0; j < point.size(); ++j) {
    for (const double bound : {program.lower[j], program.upper[j]}) {
      if (std::isfinite(bound) && is_noise(point[j] - Rational{bound})) met.push_back({{{j, 1}}, bound});
    }
  }
  for (int r = 0; r < program.rows(); ++r) {
    Equation row{.right = program.bound[static_cast<std::size_t>(r)]};
    for (const auto& [column, value] : program.row(r)) {
      if (value != 0) row.coefficients.emplace(static_cast<std::size_t>(column), value);
    }
    if (is_noise(sum(row, point) - row.right)) met.push_back(std::move(row));
  }
  return exact_solution(std::move(met), std::move(point));
}

// The program whose feasible points are the directions in which feasible points of `program` are unbounded.
lp::LinearProgram recession_program(lp::LinearProgram program) {
  for (double& bound : program.lower) bound = std::isfinite(bound) ? 0 : bound;
  for (double& bound : program.upper) bound = std::isfinite(bound) ? 0 : bound;
  std::fill(program.bound.begin(), program.bound.end(), 0);
  return program;
}

}  // namespace

lp::LinearProgram descent_program(const lp::LinearProgram& program) {
  lp::LinearProgram descent = recession_program(program);
  for (double& bound : descent.lower) bound = std::max(bound, -1.0);
  for (double& bound : descent.upper) bound = std::min(bound, 1.0);
  return descent;
}

double infeasible_by(const lp::LinearProgram& program, std::span<const double> prices) {
  if (std::none_of(prices.begin(), prices.end(), [](double price) { return price > 0; })) return 0;
  const std::vector<Rational> exact = exact_prices(program, prices);
  Rational asked = 0;
  Rational total = 0;
  for (std::size_t r = 0; r < exact.size(); ++r) {
    if (exact[r] < 0) return 0;
    asked += exact[r] * Rational{program.bound[r]};
    total += exact[r];
  }
  const std::vector<Equation> columns = priced_columns(program, exact);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Rational weight = sum(columns[j], exact);
    if (weight == 0) continue;
    const double bound = weight > 0 ? program.upper[j] : program.lower[j];
    if (std::isinf(bound)) return 0;
    asked -= weight * Rational{bound};
  }
  if (total == 0) return 0;
  return Rational{asked / total}.convert_to<double>();
}

double falls_for_ever_by(const lp::LinearProgram& program, std::span<const double> point, std::span<const double> ray) {
  const lp::LinearProgram ways = recession_program(program);
  const std::vector<Rational> way = exact_point(ways, {ray.begin(), ray.end()});
  std::vector<Rational> start(point.begin(), point.end());
  Rational fall = 0;
  Rational longest = 0;
  for (std::size_t j = 0; j < way.size(); ++j) {
    start[j] += way[j];
    fall -= Rational{program.cost[j]} * way[j];
    longest = std::max<Rational>(longest, abs(way[j]));
  }
  if (longest == 0 || broken_by(ways, way) > 0 || broken_by(program, exact_point(program, start)) > 0) return 0;
  return Rational{fall / longest}.convert_to<double>();
}

}  // namespace selvage::test
