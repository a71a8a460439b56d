// The certificate of a linear program's solution in rational arithmetic: every double is taken as an exact number, and
// nothing is rounded.
#pragma once

#include <vector>

#include "core/lp/linear_program.h"
#include "tests/extremes/certificates/exact_equations.h"

namespace selvage::test {

// A limit for the simplex method that no program of these tests reaches.
inline constexpr int kPivots = 1'000'000;

// Exact except for the final rounding to a double.
struct ExactCertificate {
  double primal{};     // the largest violation of a row or a column bound
  double dual{};       // the largest violation of dual feasibility: a negative price, or the reduced cost of a column
                       // without the bound that it needs
  double objective{};  // cost . x
  double gap{};        // cost . x minus the lower bound of the objective that the prices prove
};
[[nodiscard]] ExactCertificate exact_certificate(const lp::LinearProgram& program, const lp::LpSolution& solution);

// The largest violation of a row or a column bound by x.
[[nodiscard]] Rational broken_by(const lp::LinearProgram& program, const std::vector<Rational>& x);

}  // namespace selvage::test
