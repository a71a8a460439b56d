// The interior point iteration on one domain of a program (division.h): its vectors, and the stages of a step, each of
// which touches nothing outside of the domain.  The iteration for min c.x with A x - s = b, s >= 0, and the dual
// A^T z = c, z >= 0, is that of interior_point.h.
//
// A program that is not divided is one domain without a border.  Otherwise, a stage leaves sums over the domain's own
// rows in the border's entries, and the sums of all domains have to be added up.
// Vectors over columns end with the zero column of RowRuns, which is 0 in all of them.
#pragma once

#include <span>
#include <stop_token>

#include <Eigen/Core>

#include "core/lp/interior_point/inequality_form.h"
#include "core/lp/interior_point/normal_equations.h"
#include "core/lp/interior_point/row_runs.h"

namespace selvage::lp::interior_point {

// The largest entry by absolute value; 0 when there is none.
[[nodiscard]] double largest_of(std::span<const double> v);

class Domain {
 public:
  // The columns of the form from `own` on are the border's.
  Domain(InequalityForm form, int own);
  Domain(const Domain&) = delete;  // its normal equations refer to its rows
  Domain& operator=(const Domain&) = delete;

  [[nodiscard]] const InequalityForm& form() const { return form_; }  // without its matrix
  [[nodiscard]] int own() const { return own_; }
  [[nodiscard]] const NormalEquations& normal() const { return normal_; }

  // Starts from x, with prices that put it on the central path: all products of a slack and its price are `product`.
  void start(std::span<const double> x, double product);

  // After start() and advance(): the domain's part of the gap s.z and of the costs c.x, and its largest residuals,
  // where `dual` is without the border's.
  struct Measure {
    double gap{}, cost{}, primal{}, dual{};
  };
  [[nodiscard]] const Measure& measure() const { return measure_; }
  // The residuals of the dual constraints of the border's columns, the domain's part.
  [[nodiscard]] std::span<const double> dual_residuals() const { return on_border(rd_); }
  // What the prices z prove: z.b <= x.(A^T z) for every x that satisfies all rows (Farkas' lemma).
  struct Proof {
    double bound{};    // z.b
    double prices{};   // the sum of z
    double columns{};  // at least the sum of |A^T z| over the columns, without the border's
  };
  [[nodiscard]] Proof proof() const;
  // Measures the residuals of the rows anew: advance() only updates them, so they gather rounding errors.
  [[nodiscard]] double measure_primal();

  // The step.  First predict(), which also factorises, then direction(); then correct() and direction(); then
  // advance().  Before each direction(), direction_on_border() has to be replaced with the solution of the border.
  //
  // False when the matrix is not positive definite in floating point, or when cancelled.
  [[nodiscard]] bool predict(double rho, const std::stop_token& stop);
  void correct(double product);
  // The entries of the border's columns in the right-hand side, the domain's part, or in the direction.
  [[nodiscard]] std::span<double> direction_on_border() {
    return {dx_.data() + own_, static_cast<std::size_t>(form_.columns() - own_)};
  }
  // The longest steps along the direction that keep slacks and prices positive; infinite when steps of any length do.
  struct Steps {
    double primal{}, dual{};
  };
  [[nodiscard]] Steps direction();
  // The gap after steps along the direction.
  [[nodiscard]] double gap_after(Steps steps) const;
  // False when x is no longer finite.
  [[nodiscard]] bool advance(Steps steps);

  [[nodiscard]] double x(int column) const { return x_[column]; }
  [[nodiscard]] double z(int row) const { return z_[row]; }

 private:
  using Vector = Eigen::ArrayXd;

  [[nodiscard]] std::span<const double> on_border(const Vector& v) const {
    return {v.data() + own_, static_cast<std::size_t>(form_.columns() - own_)};
  }
  void start_direction();
  void measure_all();

  InequalityForm form_;  // without its matrix, which is in rows_
  const int own_;
  const RowRuns rows_;
  NormalEquations normal_;
  Vector cost_;
  Eigen::Map<const Vector> bound_;
  Vector x_, s_, z_, dx_, ds_, dz_;
  Vector rp_, rd_;  // the residuals of A x - s = b and of A^T z = c
  Vector weight_;   // 1 / (s / z + delta)
  Vector target_;   // the target value of s dz + z ds
  Vector wanted_;   // the target value of A dx where the weight is large
  Measure measure_;
};

}  // namespace selvage::lp::interior_point
