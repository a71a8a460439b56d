#include "core/lp/integer/cbc.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <CbcModel.hpp>  // before the others, which do not declare all that they use

#include <CbcCutGenerator.hpp>
#include <CbcEventHandler.hpp>
#include <CbcHeuristic.hpp>
#include <CbcHeuristicDiveCoefficient.hpp>
#include <CbcHeuristicLocal.hpp>
#include <CglFlowCover.hpp>
#include <CglGomory.hpp>
#include <CglKnapsackCover.hpp>
#include <CglMixedIntegerRounding2.hpp>
#include <OsiClpSolverInterface.hpp>

#include "core/lp/solver/coin_rows.h"

namespace selvage::lp::integer {
namespace {

constexpr double kRowTolerance = 1e-7;
// Cut generators run at the root and, those that help, at every tenth node.
constexpr int kCutsEvery = -10;

// Cbc calls event() at every node; stop ends the search with its best solution.  Cbc clones and deletes its handlers,
// hence the bare new.
class StopSearchOnRequest final : public CbcEventHandler {
 public:
  explicit StopSearchOnRequest(std::stop_token token) : token_{std::move(token)} {}
  CbcAction event(CbcEvent) override { return token_.stop_requested() ? stop : noAction; }
  CbcEventHandler* clone() const override { return new StopSearchOnRequest{*this}; }

 private:
  std::stop_token token_;
};

void load(OsiClpSolverInterface& solver, const IntegerProgram& program) {
  const LinearProgram& linear = program.linear;
  solver.messageHandler()->setLogLevel(0);
  solver.setHintParam(OsiDoReducePrint, true, OsiHintTry);
  solver.loadProblem(solver::coin_rows(linear), linear.lower.data(), linear.upper.data(), linear.cost.data(),
                     linear.bound.data(), nullptr);
  solver.setDblParam(OsiPrimalTolerance, kRowTolerance);
  for (const int column : program.whole) solver.setInteger(column);
}

void add_cuts(CbcModel& model) {
  CglGomory gomory;
  gomory.setLimit(300);
  CglKnapsackCover knapsack;
  CglMixedIntegerRounding2 rounding;
  CglFlowCover flow;
  model.addCutGenerator(&gomory, kCutsEvery, "Gomory");
  model.addCutGenerator(&knapsack, kCutsEvery, "knapsack cover");
  model.addCutGenerator(&rounding, kCutsEvery, "mixed integer rounding");
  model.addCutGenerator(&flow, kCutsEvery, "flow cover");
}

void add_heuristics(CbcModel& model, int depth_of_dives) {
  CbcRounding rounding{model};
  model.addHeuristic(&rounding);
  if (depth_of_dives == 0) return;
  CbcHeuristicDiveCoefficient dive{model};
  dive.setMaxIterations(depth_of_dives);
  model.addHeuristic(&dive);
  CbcHeuristicLocal local{model};
  model.addHeuristic(&local);
}

IntegerStatus translate(const CbcModel& model, const std::stop_token& stop) {
  if (model.isProvenOptimal()) return IntegerStatus::kOptimal;
  if (model.isProvenInfeasible()) return IntegerStatus::kInfeasible;
  if (stop.stop_requested()) return IntegerStatus::kStopped;
  if (model.isNodeLimitReached()) return IntegerStatus::kWorkLimit;
  return model.status() == 1 ? IntegerStatus::kWorkLimit : IntegerStatus::kFailed;
}

// Cbc's best solution, its whole columns rounded; none when it is no solution.
void take_solution(const IntegerProgram& program, const CbcModel& model, IntegerSolution& solution) {
  const double* best = model.bestSolution();
  if (best == nullptr) return;
  std::vector<double> x(best, best + program.linear.columns());
  for (const int column : program.whole) {
    double& value = x[static_cast<std::size_t>(column)];
    value = std::round(value);
  }
  if (!is_solution(program, x)) return;
  solution.objective = objective_of(program.linear, x);
  solution.x = std::move(x);
}

}  // namespace

IntegerSolution solve_by_branch_and_cut(const IntegerProgram& program, const IntegerLimits& limits,
                                        std::span<const double> start, std::stop_token stop) {
  IntegerSolution solution;
  if (!start.empty()) {
    solution.x.assign(start.begin(), start.end());
    solution.objective = objective_of(program.linear, start);
  }
  if (stop.stop_requested()) {
    solution.status = IntegerStatus::kStopped;
    return solution;
  }
  OsiClpSolverInterface solver;
  load(solver, program);
  CbcModel model{solver};
  model.setLogLevel(0);
  model.setPrintingMode(0);
  model.setMaximumNodes(limits.nodes);
  model.setAllowableFractionGap(limits.gap);
  StopSearchOnRequest handler{stop};
  model.passInEventHandler(&handler);
  add_cuts(model);
  add_heuristics(model, limits.depth_of_dives);
  if (!start.empty()) model.setBestSolution(start.data(), program.linear.columns(), solution.objective, true);
  model.initialSolve();
  model.branchAndBound();

  solution.status = translate(model, stop);
  solution.nodes = model.getNodeCount();
  IntegerSolution found;
  take_solution(program, model, found);
  if (found.found() && (!solution.found() || found.objective < solution.objective)) {
    solution.x = std::move(found.x);
    solution.objective = found.objective;
  }
  const bool decided = solution.status == IntegerStatus::kInfeasible || solution.status == IntegerStatus::kOptimal;
  solution.bound = model.getBestPossibleObjValue();
  // With a start, "infeasible" says that nothing is better than it.
  if (solution.found() && (solution.bound > solution.objective || (decided && limits.gap == 0)))
    solution.bound = solution.objective;
  if (solution.status == IntegerStatus::kInfeasible) {
    if (solution.found())
      solution.status = IntegerStatus::kOptimal;
    else
      solution.bound = kInfinity;
  }
  return solution;
}

}  // namespace selvage::lp::integer
