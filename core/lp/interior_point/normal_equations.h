// The normal equations of an inequality form: (A^T W A + rho I) x = r for a positive diagonal W, solved repeatedly with
// the same A.
#pragma once

#include <memory>
#include <span>
#include <stop_token>

#include "core/lp/interior_point/row_runs.h"

namespace selvage::lp::interior_point {

class NormalEquations {
 public:
  // Computes the sparsity pattern, an elimination order with little fill, and the position of each run's products.
  // Keeps a reference to `rows`.
  explicit NormalEquations(const RowRuns& rows);
  ~NormalEquations();

  // False when the matrix is not positive definite in floating point, or when cancelled (block_cholesky.h).
  [[nodiscard]] bool factorise(std::span<const double> weight, double rho, const std::stop_token& stop);
  // Solves in place; entries after the last column are unchanged.
  void solve(std::span<double> right_side);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace selvage::lp::interior_point
