#include "bench/lp/clp_variants.h"

#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <CoinPackedMatrix.hpp>
#include <CoinPackedVector.hpp>

#include "core/lp/interior_point/inequality_form.h"

namespace selvage::bench {
namespace {

constexpr double kTolerance = 1e-9;

void load(ClpSimplex& clp, const lp::LinearProgram& program) {
  CoinPackedMatrix matrix{false, 0, 0};
  matrix.setDimensions(0, program.columns());
  for (int r = 0; r < program.rows(); ++r) {
    CoinPackedVector row;
    for (const auto& [column, value] : program.row(r)) row.insert(column, value);
    matrix.appendRow(row);
  }
  clp.setLogLevel(0);
  clp.loadProblem(matrix, program.lower.data(), program.upper.data(), program.cost.data(), program.bound.data(),
                  nullptr);
  clp.setPrimalTolerance(kTolerance);
  clp.setDualTolerance(kTolerance);
  clp.setDblParam(ClpPresolveTolerance, kTolerance);
}

// Solves the explicit dual: minimise -bound . z subject to A^T z = cost, z >= 0.  The prices of its rows are the values
// of the program's columns.  (Clp's own dualOfModel throws on columns with a finite bound.)
lp::LpSolution solve_dualised(const lp::LinearProgram& program) {
  const auto form = lp::interior_point::inequality_form(program, kTolerance);
  if (!form) return {};
  CoinPackedMatrix matrix{true, 0, 0};  // a column of the dual is a row of the form
  matrix.setDimensions(form->columns(), 0);
  for (std::size_t r = 0; r < form->bound.size(); ++r) {
    const int start = form->row_start[r];
    matrix.appendCol(form->row_start[r + 1] - start, form->column.data() + start, form->value.data() + start);
  }
  std::vector<double> cost;
  for (const double bound : form->bound) cost.push_back(-bound);
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.loadProblem(matrix, nullptr, nullptr, cost.data(), form->cost.data(), form->cost.data());
  clp.setPrimalTolerance(kTolerance);
  clp.setDualTolerance(kTolerance);
  clp.dual();
  lp::LpSolution solution{.iterations = clp.numberIterations()};
  if (clp.status() != 0) return solution;
  solution.status = lp::LpStatus::kOptimal;
  solution.x = program.lower;  // the values of fixed columns
  const double* price = clp.dualRowSolution();
  for (std::size_t k = 0; k < form->cost.size(); ++k) {
    solution.x[static_cast<std::size_t>(form->program_column[k])] = -price[k];
  }
  for (std::size_t j = 0; j < program.cost.size(); ++j) solution.objective += program.cost[j] * solution.x[j];
  return solution;
}

void solve(ClpSimplex& clp, ClpVariant variant) {
  ClpSolve options;
  const bool presolved = variant == ClpVariant::kDualPresolved || variant == ClpVariant::kPrimalPresolved;
  options.setPresolveType(presolved ? ClpSolve::presolveOn : ClpSolve::presolveOff);
  switch (variant) {
    case ClpVariant::kPrimal:
    case ClpVariant::kPrimalPresolved: options.setSolveType(ClpSolve::usePrimal); break;
    case ClpVariant::kBarrier: options.setSolveType(ClpSolve::useBarrier); break;
    case ClpVariant::kBarrierNoVertex: options.setSolveType(ClpSolve::useBarrierNoCross); break;
    default: options.setSolveType(ClpSolve::useDual); break;
  }
  clp.initialSolve(options);
}

}  // namespace

lp::LpSolution solve_by_clp(const lp::LinearProgram& program, ClpVariant variant) {
  if (variant == ClpVariant::kDualised) return solve_dualised(program);
  ClpSimplex clp;
  load(clp, program);
  solve(clp, variant);
  lp::LpSolution solution{.iterations = clp.numberIterations()};
  if (clp.status() != 0) return solution;
  solution.status = lp::LpStatus::kOptimal;
  const double* x = clp.primalColumnSolution();
  solution.x.assign(x, x + program.columns());
  solution.objective = clp.objectiveValue();
  return solution;
}

}  // namespace selvage::bench
