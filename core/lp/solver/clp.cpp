#include "core/lp/solver/clp.h"

#include <algorithm>
#include <array>
#include <utility>

#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <CoinPackedMatrix.hpp>

#include "core/lp/certificate.h"

namespace selvage::lp::solver {
namespace {

constexpr double kTolerance = 1e-9;
// Below this many rows the presolve costs more than the pivots it saves (bench/lp/lp_benchmark).
constexpr int kPresolveFromRows = 60;

// Clp asks at every pivot; 0 ends the solve with status 5.  Clp clones and deletes its handlers, hence the bare new.
class StopOnRequest final : public ClpEventHandler {
 public:
  explicit StopOnRequest(std::stop_token stop) : stop_{std::move(stop)} {}
  int event(Event) override { return stop_.stop_requested() ? 0 : -1; }
  ClpEventHandler* clone() const override { return new StopOnRequest{*this}; }

 private:
  std::stop_token stop_;
};

CoinPackedMatrix packed_rows(const LinearProgram& program) {
  std::vector<int> column(program.entries.size());
  std::vector<double> value(program.entries.size());
  for (std::size_t k = 0; k < program.entries.size(); ++k) {
    column[k] = program.entries[k].column;
    value[k] = program.entries[k].value;
  }
  const std::vector<CoinBigIndex> start(program.row_start.begin(), program.row_start.end());
  return {false,        program.columns(), program.rows(), static_cast<CoinBigIndex>(column.size()),
          value.data(), column.data(),     start.data(),   nullptr};
}

void load(ClpSimplex& clp, const LinearProgram& program) {
  clp.setLogLevel(0);
  clp.loadProblem(packed_rows(program), program.lower.data(), program.upper.data(), program.cost.data(),
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

// How to ask Clp.  Rows come with a largest coefficient of about 1 and want no scaling: Clp's would take the dust in
// them (the cosine of a right angle is 6e-17) for a scale, and call optimal what is so within its tolerance times 1e8.
// Rows that come otherwise need it.
struct Way {
  ClpSolve::SolveType method{};
  bool presolve{}, scaled{};
};

LpSolution solve_once(const LinearProgram& program, Way way, int pivot_limit, const std::stop_token& stop) {
  ClpSimplex clp;
  load(clp, program);
  if (!way.scaled) clp.scaling(0);
  clp.setMaximumIterations(pivot_limit);
  StopOnRequest handler{stop};
  clp.passInEventHandler(&handler);

  ClpSolve options;
  options.setSolveType(way.method);
  options.setPresolveType(way.presolve ? ClpSolve::presolveOn : ClpSolve::presolveOff);
  clp.initialSolve(options);

  LpSolution solution{.status = translate(clp.status()), .iterations = clp.numberIterations()};
  if (solution.status != LpStatus::kOptimal) return solution;
  const double* x = clp.primalColumnSolution();
  const double* dual = clp.dualRowSolution();
  solution.x.assign(x, x + program.columns());
  solution.dual.assign(dual, dual + program.rows());
  for (double& price : solution.dual) price = std::max(price, 0.0);  // rounding makes some -1e-17
  solution.objective = clp.objectiveValue();
  return solution;
}

// Whether the answer is what it says it is.  What is infeasible or unbounded comes without a proof that could be looked
// at (most of Clp's rays are none): solve() asks once more.
bool holds(const LinearProgram& program, const LpSolution& solution) {
  if (solution.status == LpStatus::kFailed) return false;
  return solution.status != LpStatus::kOptimal || certificate_of(program, solution).closes();
}

}  // namespace

LpSolution solve_by_simplex(const LinearProgram& program, int pivot_limit, std::stop_token stop) {
  if (stop.stop_requested()) return {.status = LpStatus::kStopped};
  const bool presolve = program.rows() >= kPresolveFromRows;
  // The quick way first; the others, from scratch, when its answer does not prove itself.
  const std::array<Way, 4> ways{{{ClpSolve::useDual, presolve, false},
                                 {ClpSolve::useDual, presolve, true},
                                 {ClpSolve::useDual, !presolve, false},
                                 {ClpSolve::usePrimal, false, false}}};
  int pivots = 0;
  for (const Way way : ways) {
    LpSolution solution = solve_once(program, way, pivot_limit - pivots, stop);
    solution.iterations = pivots += solution.iterations;
    if (holds(program, solution)) return solution;
  }
  return {.status = LpStatus::kFailed, .iterations = pivots};
}

}  // namespace selvage::lp::solver
