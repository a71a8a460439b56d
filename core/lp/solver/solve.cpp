#include "core/lp/solver/solve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/lp/interior_point/interior_point.h"
#include "core/lp/phase_one_program.h"
#include "core/lp/solver/clp.h"

namespace selvage::lp::solver {
namespace {

// From this many rows on, the interior point method takes no more instructions than simplex on the programs of real
// markers, and reaches the same lengths.  For small scenes a vertex solution is preferred: there it is one lattice unit
// shorter and moves pieces less.
constexpr int kInteriorPointFromRows = 60;
constexpr double kLargestInfeasibility = 1e-9;
// From this many rows on, simplex takes far longer than the interior point method to find that a program is infeasible.
constexpr int kPhaseOneFirstFromRows = 2000;
// With more columns than this, simplex would take minutes where the interior point method has failed.
constexpr int kMostColumnsOfSimplex = 5000;
// An infeasibility that rounding cannot have made.
constexpr double kClearInfeasibility = 1e-6;

// Detects programs that neither solver should be given.  kFailed: not a linear program.
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

// The status when simplex finds no optimum.  With free columns, Clp sometimes reports feasible programs as infeasible
// and infeasible ones as unbounded; the phase one program decides how far the rows would have to be relaxed.
LpStatus confirmed_status(const LinearProgram& program, LpStatus reported, const std::stop_token& stop,
                          const Executor& executor) {
  const LpSolution phase_one = interior_point::solve_by_interior_point(phase_one_program(program), {}, stop, executor);
  if (phase_one.status == LpStatus::kStopped) return LpStatus::kStopped;
  if (phase_one.status != LpStatus::kOptimal) return reported;
  if (phase_one.objective > kLargestInfeasibility) return LpStatus::kInfeasible;
  return reported == LpStatus::kUnbounded ? reported : LpStatus::kFailed;
}

// True when the rows of a large program have to be relaxed by far more than rounding.
bool is_clearly_infeasible(const LinearProgram& program, const std::stop_token& stop, const Executor& executor) {
  if (program.rows() < kPhaseOneFirstFromRows) return false;
  const LpSolution phase_one = interior_point::solve_by_interior_point(phase_one_program(program), {}, stop, executor);
  return phase_one.status == LpStatus::kOptimal && phase_one.objective > kClearInfeasibility;
}

}  // namespace

double allowed_violation(const LinearProgram& program) {
  return std::max(kLargestInfeasibility, interior_point::attainable_violation(program));
}

LpSolution solve(const LinearProgram& program, SolverChoice choice, const LpLimits& limits, std::stop_token stop,
                 const Executor& executor) {
  if (stop.stop_requested()) return {.status = LpStatus::kStopped};
  if (const LpStatus status = precheck(program); status != LpStatus::kOptimal) return {.status = status};
  if (program.columns() == 0) return solve_without_columns(program);
  const auto interior = [&]() -> std::optional<LpSolution> {
    interior_point::InteriorPointSettings settings = interior_point::settings_for_tolerance(limits.tolerance);
    settings.reach = limits.reach;
    if (program.columns() > kMostColumnsOfSimplex) settings.stalls = settings.iterations;
    LpSolution solution = solve_by_interior_point(program, settings, stop, executor);
    if (solution.status == LpStatus::kStopped || solution.status == LpStatus::kInfeasible) return solution;
    const bool solved = solution.status == LpStatus::kOptimal;
    if (solved && infeasibility(program, solution.x) <= allowed_violation(program)) return solution;
    return std::nullopt;
  };
  const bool interior_first = prefers_interior_point(program, choice);
  if (interior_first) {
    if (auto solution = interior()) return *solution;
    if (!limits.falls_back) return {.status = LpStatus::kFailed};
    if (is_clearly_infeasible(program, stop, executor)) return {.status = LpStatus::kInfeasible};
    if (stop.stop_requested()) return {.status = LpStatus::kStopped};
    if (program.columns() > kMostColumnsOfSimplex) return {.status = LpStatus::kFailed};
  }
  LpSolution vertex = solve_by_simplex(program, limits.iterations, stop);
  const bool conclusive = vertex.status == LpStatus::kOptimal || vertex.status == LpStatus::kWorkLimit;
  if (conclusive || vertex.status == LpStatus::kStopped) return vertex;
  vertex.status = confirmed_status(program, vertex.status, stop, executor);
  if (vertex.status != LpStatus::kFailed || interior_first) return vertex;
  return interior().value_or(vertex);
}

}  // namespace selvage::lp::solver
