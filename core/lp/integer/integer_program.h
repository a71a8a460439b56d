// An integer program as a value: a linear program some of whose columns must be whole numbers.
//
// Units: those of the linear program.  Whole means within kWholeTolerance of a whole number: a caller that needs exact
// counts rounds the columns and checks its own constraints in integers.
#pragma once

#include <span>
#include <vector>

#include "core/lp/linear_program.h"

namespace selvage::lp::integer {

inline constexpr double kWholeTolerance = 1e-6;

struct IntegerProgram {
  LinearProgram linear;
  std::vector<int> whole;  // the columns that must be whole numbers, each once

  int add_whole_column(double cost, double low, double high) {
    whole.push_back(linear.add_column(cost, low, high));
    return whole.back();
  }
};

enum class IntegerStatus {
  kOptimal,     // the solution is within the gap of the bound
  kInfeasible,  // there is no solution, or none that is better than the start
  kWorkLimit,   // all allowed nodes were used
  kStopped,     // cancelled
  kFailed,      // the solver gave up, or returned something that is not a solution
};

// The outcome of a search.  The status says why it ended; with any status there may be a solution.
struct IntegerSolution {
  IntegerStatus status{IntegerStatus::kFailed};
  std::vector<double> x{};   // one per column, whole ones rounded; empty: no solution was found
  double objective{};        // of x
  double bound{-kInfinity};  // no solution has a smaller objective, up to the rounding of floating point
  int nodes{};
  [[nodiscard]] bool found() const { return !x.empty(); }
};

// Whether x satisfies all rows and bounds within `tolerance`, and the whole columns are whole numbers.
[[nodiscard]] bool is_solution(const IntegerProgram& program, std::span<const double> x, double tolerance = 1e-6);
[[nodiscard]] double objective_of(const LinearProgram& program, std::span<const double> x);

}  // namespace selvage::lp::integer
