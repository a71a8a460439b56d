#include "core/lp/solver/solve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/phase_one_program.h"
#include "core/lp/solver/clp.h"

namespace selvage::lp::solver {
namespace {

// From here on the interior point method takes no more instructions than the other on the programs of real markers, at
// the same lengths.  Of small scenes a vertex is wanted: there it is a lattice unit shorter, and moves less.
constexpr int kInteriorPointFromRows = 60;
// What an answer of the interior point method may break a row by before it is not believed.
constexpr double kLargestInfeasibility = 1e-9;

// What neither solver should see.  kFailed: not a linear program.
LpStatus precheck(const LinearProgram& program) {
  const auto is_nan = [](double value) { return std::isnan(value); };
  const auto broken = [&](const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), is_nan);
  };
  if (broken(program.cost) || broken(program.lower) || broken(program.upper) || broken(program.bound)) {
    return LpStatus::kFailed;
  }
  for (std::size_t j = 0; j < program.cost.size(); ++j) {
    if (program.lower[j] > program.upper[j]) return LpStatus::kInfeasible;
  }
  return LpStatus::kOptimal;
}

LpSolution solve_without_columns(const LinearProgram& program) {
  const bool feasible = infeasibility(program, {}) <= kLargestInfeasibility;
  if (!feasible) return {.status = LpStatus::kInfeasible};
  return {.status = LpStatus::kOptimal, .dual = std::vector<double>(program.bound.size())};
}

bool prefers_interior_point(const LinearProgram& program, SolverChoice choice) {
  if (choice == SolverChoice::kAutomatic) return program.rows() >= kInteriorPointFromRows;
  return choice == SolverChoice::kInteriorPoint;
}

// What is so when simplex finds no best point.  Where columns are free Clp at times calls infeasible what is not, and
// unbounded what is infeasible; the other method tells by how little the rows would have to give way.
LpStatus without_best_point(const LinearProgram& program, LpStatus said, const std::stop_token& stop) {
  const LpSolution shortage = interior_point::solve_by_interior_point(phase_one_program(program), {}, stop);
  if (shortage.status == LpStatus::kStopped) return LpStatus::kStopped;
  if (shortage.status != LpStatus::kOptimal) return said;
  if (shortage.objective > kLargestInfeasibility) return LpStatus::kInfeasible;
  return said == LpStatus::kUnbounded ? said : LpStatus::kFailed;
}

}  // namespace

LpSolution solve(const LinearProgram& program, SolverChoice choice, const LpLimits& limits, std::stop_token stop) {
  if (stop.stop_requested()) return {.status = LpStatus::kStopped};
  if (const LpStatus status = precheck(program); status != LpStatus::kOptimal) return {.status = status};
  if (program.columns() == 0) return solve_without_columns(program);
  const auto interior = [&]() -> std::optional<LpSolution> {
    LpSolution solution = solve_by_interior_point(program, interior_point::settled_within(limits.tolerance), stop);
    if (solution.status == LpStatus::kStopped) return solution;
    const bool solved = solution.status == LpStatus::kOptimal;
    if (solved && infeasibility(program, solution.x) <= kLargestInfeasibility) return solution;
    return std::nullopt;
  };
  const bool interior_first = prefers_interior_point(program, choice);
  if (interior_first) {
    if (auto solution = interior()) return *solution;
  }
  LpSolution vertex = solve_by_simplex(program, limits.iterations, stop);
  const bool at_an_end = vertex.status == LpStatus::kOptimal || vertex.status == LpStatus::kWorkLimit;
  if (at_an_end || vertex.status == LpStatus::kStopped) return vertex;
  vertex.status = without_best_point(program, vertex.status, stop);
  if (vertex.status != LpStatus::kFailed || interior_first) return vertex;
  return interior().value_or(vertex);
}

}  // namespace selvage::lp::solver
