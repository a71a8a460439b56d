// The normal equations of an inequality form: (A^T W A + rho I) x = r for a positive diagonal W, over and over with the
// same A.
#pragma once

#include <memory>
#include <span>

#include "core/lp/inequality_form.h"

namespace selvage {

class NormalEquations {
 public:
  // Finds the pattern and where each row's products fall in it.  Keeps a reference to `form`.
  explicit NormalEquations(const InequalityForm& form);
  ~NormalEquations();

  // False when the matrix is not positive definite in floating point.
  [[nodiscard]] bool factorise(std::span<const double> weight, double rho);
  // Solves in place.
  void solve(std::span<double> right_side);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace selvage
