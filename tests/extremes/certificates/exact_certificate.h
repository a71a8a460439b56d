// The certificate of a linear program's answer in rationals: every double taken as the number it is, nothing rounded.
#pragma once

#include <vector>

#include "core/lp/linear_program.h"
#include "tests/extremes/certificates/exact_equations.h"

namespace selvage::test {

// Exact but for the last rounding to a double.
struct ExactCertificate {
  double primal{};     // the most by which a row or a column bound is broken
  double dual{};       // the largest price below zero, or reduced cost of a column without the bound it would rest on
  double objective{};  // cost . x
  double gap{};        // cost . x less what the prices prove the objective to be at least
};
[[nodiscard]] ExactCertificate exact_certificate(const lp::LinearProgram& program, const lp::LpSolution& solution);

// The most by which x breaks a row or a column bound.
[[nodiscard]] Rational broken_by(const lp::LinearProgram& program, const std::vector<Rational>& x);

}  // namespace selvage::test
