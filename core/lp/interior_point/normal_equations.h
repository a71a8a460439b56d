// The normal equations of an inequality form: (A^T W A + rho I) x = r for a positive diagonal W, solved repeatedly with
// the same A.
//
// The last columns may be kept, because they also occur in rows of other domains (border.h): then only the other
// columns are eliminated, and what remains of the matrix and of the right-hand side is added to the remainders of those
// domains.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>

#include "core/lp/interior_point/row_runs.h"

namespace selvage::lp::interior_point {

class NormalEquations {
 public:
  // Computes the sparsity pattern, an elimination order with little fill, and the position of each run's products.
  // The columns from `own` on are kept.  Stores a reference to `rows`.
  NormalEquations(const RowRuns& rows, int own);
  explicit NormalEquations(const RowRuns& rows) : NormalEquations{rows, rows.columns} {}
  ~NormalEquations();

  // Adds rho to the diagonal of the columns that are eliminated.  False when the matrix is not positive definite in
  // floating point, or when cancelled (core/lp/elimination/block_cholesky.h).
  [[nodiscard]] bool factorise(std::span<const double> weight, double rho, const std::stop_token& stop);

  // Solve in place, one after the other; entries after the last column are unchanged.  Between the two calls, the
  // entries of the kept columns are the right-hand side that remains, and have to be replaced with its solution.
  void solve_lower(std::span<double> right_side);
  void solve_upper(std::span<double> right_side);

  // The entry of two kept columns in the matrix that remains; null where there is none.  Stays at its address.
  [[nodiscard]] const double* remaining(int i, int j) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace selvage::lp::interior_point
