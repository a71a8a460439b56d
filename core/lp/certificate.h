// A certificate proves that a solution of a linear program is optimal: the solution violates no row, no column has a
// reduced cost that would let it improve, and the objective equals the lower bound that the dual prices prove.
// Checking it takes a few passes over the entries, so a solver's own status need not be trusted.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::lp {

struct Certificate {
  double primal{};  // the largest violation of a row or of a column bound
  double dual{};    // the largest violation of dual feasibility: a negative price, or the reduced cost of a column
                    // without the bound that it needs
  double gap{};     // |objective - lower bound proved by the prices| / (1 + |objective|)

  // True when the certificate is accurate enough for steps, which are rounded to the lattice and proved there.
  [[nodiscard]] bool closes() const { return primal <= 1e-8 && dual <= 1e-7 && gap <= 1e-6; }
};

// REQUIRES: `x` has an entry per column and `dual` has one per row.
[[nodiscard]] Certificate certificate_of(const LinearProgram& program, const LpSolution& solution);

}  // namespace selvage::lp
