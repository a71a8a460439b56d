// What proves a linear program's answer optimal: it breaks no row, its prices leave no column that should move, and the
// objective that the prices promise at least is the one that the answer has.  A few passes over the entries: what a
// solver says of its own answer need not be believed.
#pragma once

#include "core/lp/linear_program.h"

namespace selvage::lp {

struct Certificate {
  double primal{};  // the most by which a row or a column bound is broken
  double dual{};    // the largest price below zero, or reduced cost of a column without the bound it would rest on
  double gap{};     // objective less what the prices prove it to be at least, over 1 + |objective|

  // Good enough for what is made of answers: steps that are rounded to the lattice and proved there.
  [[nodiscard]] bool closes() const { return primal <= 1e-8 && dual <= 1e-7 && gap <= 1e-6; }
};

// REQUIRES: `x` and `dual` have an entry per column and row.
[[nodiscard]] Certificate certificate_of(const LinearProgram& program, const LpSolution& solution);

}  // namespace selvage::lp
