#include "core/lp/solver/clp.h"

#include <algorithm>
#include <array>
#include <utility>

#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>

#include "core/lp/certificate.h"
#include "core/lp/solver/coin_rows.h"

namespace selvage::lp::solver {
namespace {

constexpr double kTolerance = 1e-9;
// Below this many rows, presolve costs more than the pivots that it saves (bench/lp/lp_benchmark).
constexpr int kPresolveFromRows = 60;

// Clp calls event() at every pivot; returning 0 ends the solve with status 5.  Clp clones and deletes its handlers,
// hence the bare new.
class StopOnRequest final : public ClpEventHandler {
 public:
  explicit StopOnRequest(std::stop_token stop) : stop_{std::move(stop)} {}
  int event(Event) override { return stop_.stop_requested() ? 0 : -1; }
  ClpEventHandler* clone() const override { return new StopOnRequest{*this}; }

 private:
  std::stop_token stop_;
};

void load(ClpSimplex& clp, const LinearProgram& program) {
  clp.setLogLevel(0);
  clp.loadProblem(coin_rows(program), program.lower.data(), program.upper.data(), program.cost.data(),
                  program.bound.data(), nullptr);
  clp.setPrimalTolerance(kTolerance);
  clp.setDualTolerance(kTolerance);
  clp.setDblParam(ClpPresolveTolerance, kTolerance);
}

LpStatus translate(int clp_status) {
  switch (clp_status) {
    case 0: return LpStatus::kOptimal;
    case 1: return LpStatus::kInfeasible;
    case 2: return LpStatus::kUnbounded;
    case 3: return LpStatus::kWorkLimit;
    case 5: return LpStatus::kStopped;
    default: return LpStatus::kFailed;
  }
}

// A configuration of Clp.
//
// The rows of the models have a largest coefficient of about 1 and need no scaling.  Clp's scaling would treat rounding
// noise (the cosine of a right angle is 6e-17) as significant, and accept solutions that are optimal only within 1e8
// times the tolerance.  Other rows need scaling.
struct Configuration {
  ClpSolve::SolveType method{};
  bool presolve{}, scaled{};
};

LpSolution solve_once(const LinearProgram& program, Configuration configuration, int pivot_limit,
                      const std::stop_token& stop) {
  ClpSimplex clp;
  load(clp, program);
  if (!configuration.scaled) clp.scaling(0);
  clp.setMaximumIterations(pivot_limit);
  StopOnRequest handler{stop};
  clp.passInEventHandler(&handler);

  ClpSolve options;
  options.setSolveType(configuration.method);
  options.setPresolveType(configuration.presolve ? ClpSolve::presolveOn : ClpSolve::presolveOff);
  clp.initialSolve(options);

  LpSolution solution{.status = translate(clp.status()), .iterations = clp.numberIterations()};
  if (solution.status != LpStatus::kOptimal) return solution;
  const double* x = clp.primalColumnSolution();
  const double* dual = clp.dualRowSolution();
  solution.x.assign(x, x + program.columns());
  solution.dual.assign(dual, dual + program.rows());
  for (double& price : solution.dual) price = std::max(price, 0.0);  // rounding makes some prices slightly negative
  solution.objective = clp.objectiveValue();
  return solution;
}

// Whether the solution can be accepted.  Infeasible and unbounded results come without a proof that could be checked
// (most of Clp's rays are invalid); solve() verifies them by another method.
bool is_acceptable(const LinearProgram& program, const LpSolution& solution) {
  if (solution.status == LpStatus::kFailed) return false;
  return solution.status != LpStatus::kOptimal || certificate_of(program, solution).closes();
}

}  // namespace

LpSolution solve_by_simplex(const LinearProgram& program, int pivot_limit, std::stop_token stop) {
  if (stop.stop_requested()) return {.status = LpStatus::kStopped};
  const bool presolve = program.rows() >= kPresolveFromRows;
  // The fastest configuration comes first; the others start from scratch when its solution is not certified.
  const std::array<Configuration, 4> configurations{{{ClpSolve::useDual, presolve, false},
                                                     {ClpSolve::useDual, presolve, true},
                                                     {ClpSolve::useDual, !presolve, false},
                                                     {ClpSolve::usePrimal, false, false}}};
  int pivots = 0;
  for (const Configuration configuration : configurations) {
    LpSolution solution = solve_once(program, configuration, pivot_limit - pivots, stop);
    solution.iterations = pivots += solution.iterations;
    if (is_acceptable(program, solution)) return solution;
  }
  return {.status = LpStatus::kFailed, .iterations = pivots};
}

}  // namespace selvage::lp::solver
