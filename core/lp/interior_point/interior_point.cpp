#include "core/lp/interior_point/interior_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/lp/interior_point/inequality_form.h"
#include "core/lp/interior_point/normal_equations.h"
#include "core/lp/interior_point/row_runs.h"

namespace selvage::lp::interior_point {
namespace {

using Vector = Eigen::ArrayXd;

// Proximal weights of the columns, tried in turn: near the end rounding can leave a matrix that needs more.  They hold
// the step back, they do not move the answer: its residuals are measured without them.
constexpr std::array<double, 4> kRho{1e-9, 1e-6, 1e-4, 1e-2};
// A column that only a far bound holds moves by its cost over rho at a time: once all else is settled rho gives way.
constexpr double kEasier = 0.1;
constexpr double kLeastEase = 1e-4;
constexpr double kRoundings = 4;  // of the largest bound: no row can be met more exactly than that
constexpr double kDelta = 1e-11;  // proximal weight of the rows' multipliers
constexpr double kLeastStartingSlack = 1;
constexpr double kCentring = 3;  // the power of the predicted part of the gap that the corrector aims at
constexpr double kBelieved =
    5e-10;  // what a row may be broken by when the gap need not close: solve() believes twice that
constexpr double kDualPart = 1e-2;   // of a tolerance for the gap, what is left for the dual's residual
constexpr double kLeastCost = 1e-3;  // a program without costs has a centre all the same

std::span<double> span_of(Vector& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}
Vector vector_of(std::span<const double> v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}

double dot(const Vector& a, const Vector& b) {
  return a.matrix().dot(b.matrix());
}

double largest(const Vector& a) {
  return a.size() == 0 ? 0 : a.abs().maxCoeff();
}

// The step along which v loses all that an entry of it has; infinite when none shrinks.
double longest_step(const Vector& v, const Vector& dv) {
  const double shrinks = v.size() == 0 ? 0 : (-dv / v).maxCoeff();
  return shrinks > 0 ? 1 / shrinks : kInfinity;
}

// min c.x with A x - s = b, s >= 0, and the dual A^T z = c, z >= 0.  Vectors of columns end with that of RowRuns which
// stays still: 0 in all of them.
class Iteration {
 public:
  Iteration(const InequalityForm& form, const InteriorPointSettings& settings)
      : rows_{row_runs(form)},
        settings_{settings},
        normal_{rows_},
        cost_{vector_of(form.cost)},
        bound_{vector_of(form.bound)},
        largest_cost_{largest(cost_)} {
    primal_ = std::max(settings.primal, kRoundings * std::numeric_limits<double>::epsilon() * largest(bound_));
    cost_.conservativeResize(form.columns() + 1);
    cost_[form.columns()] = 0;
    for (Vector* v : {&x_, &dx_, &rd_}) v->setZero(form.columns() + 1);
    for (Vector* v : {&s_, &z_, &ds_, &dz_, &rp_, &weight_, &target_, &wanted_}) v->setZero(form.rows());
  }

  void start(std::span<const double> x);
  bool converged();
  bool step();  // false when it can go no further

  [[nodiscard]] const Vector& x() const { return x_; }
  [[nodiscard]] const Vector& z() const { return z_; }

 private:
  bool factorise();
  void measure_primal();
  void direction();

  const RowRuns rows_;
  const InteriorPointSettings& settings_;
  NormalEquations normal_;
  Vector cost_, bound_;
  double largest_cost_;
  Vector x_, s_, z_, dx_, ds_, dz_;
  Vector rp_, rd_;                // what is missing from A x - s = b and from A^T z = c
  Vector weight_;                 // 1 / (s / z + delta)
  Vector target_;                 // what s dz + z ds is to be
  Vector wanted_;                 // what A dx is to be where the weight is large
  double gap_{};                  // s . z
  double least_dual_{kInfinity};  // so far
  double primal_{};               // the most a row may be broken by
  double ease_{1};                // what rho is multiplied by
};

void Iteration::start(std::span<const double> x) {
  std::copy(x.begin(), x.end(), x_.data());
  multiply(rows_, span_of(x_), span_of(s_));
  s_ = (s_ - bound_).max(kLeastStartingSlack);
  z_ = std::max(largest_cost_, kLeastCost) / s_;  // every product s z the same: the central path
  measure_primal();
}

void Iteration::measure_primal() {
  multiply(rows_, span_of(x_), span_of(rp_));
  rp_ = bound_ + s_ - rp_;
}

bool Iteration::converged() {
  multiply_transposed(rows_, span_of(z_), span_of(rd_));
  rd_ = cost_ - rd_;
  rd_[rows_.still()] = 0;
  gap_ = dot(s_, z_);
  const double dual = largest(rd_) / (1 + largest_cost_);
  const bool at_rest = dual > least_dual_ / 2;
  least_dual_ = std::min(least_dual_, dual);
  const bool closed = gap_ <= settings_.gap * (1 + std::abs(dot(cost_, x_)));
  if (closed && at_rest) ease_ = std::max(kLeastEase, kEasier * ease_);
  if (!closed || largest(rp_) > primal_) return false;
  if (dual > settings_.dual && !(at_rest && dual <= settings_.dual_at_rest)) return false;
  measure_primal();  // steps only keep it up to date
  return largest(rp_) <= primal_;
}

bool Iteration::factorise() {
  weight_ = z_ / (s_ + kDelta * z_);
  return std::any_of(kRho.begin(), kRho.end(),
                     [&](double rho) { return normal_.factorise(span_of(weight_), ease_ * rho); });
}

// (dx, ds, dz) with A dx - ds + delta dz = rp, A^T dz - rho dx = rd, s dz + z ds = target.
void Iteration::direction() {
  wanted_ = rp_ + target_ / z_;
  dz_ = weight_ * wanted_;
  multiply_transposed(rows_, span_of(dz_), span_of(dx_));
  dx_ -= rd_;
  normal_.solve(span_of(dx_));
  dx_[rows_.still()] = 0;
  multiply(rows_, span_of(dx_), span_of(ds_));
  dz_ = weight_ * (wanted_ - ds_);
  ds_ += kDelta * dz_ - rp_;
}

bool Iteration::step() {
  if (!factorise()) return false;
  const double mu = gap_ / static_cast<double>(s_.size());
  target_ = -s_ * z_;
  direction();
  double primal = std::min(1.0, longest_step(s_, ds_));
  double dual = std::min(1.0, longest_step(z_, dz_));
  const double affine = ((s_ + primal * ds_) * (z_ + dual * dz_)).sum();
  const double sigma = std::pow(affine / gap_, kCentring);
  target_ = sigma * mu - s_ * z_ - ds_ * dz_;
  direction();
  // Nearer to the boundary as the gap closes, never onto it.
  const double keep = std::clamp(1 - mu, 0.99, 0.9995);
  primal = std::min(1.0, keep * longest_step(s_, ds_));
  dual = std::min(1.0, keep * longest_step(z_, dz_));
  x_ += primal * dx_;
  s_ += primal * ds_;
  z_ += dual * dz_;
  rp_ -= primal * (rp_ - kDelta * dz_);
  return std::isfinite(dot(x_, x_));
}

}  // namespace

InteriorPointSettings settled_within(double tolerance) {
  InteriorPointSettings settings;
  if (tolerance <= settings.gap) return settings;
  settings.gap = tolerance;
  settings.primal = std::max(settings.primal, kBelieved);
  settings.dual = std::max(settings.dual, kDualPart * tolerance);
  settings.dual_at_rest = std::max(settings.dual_at_rest, settings.dual);
  return settings;
}

LpSolution solve_by_interior_point(const LinearProgram& program, const InteriorPointSettings& settings,
                                   std::stop_token stop) {
  const auto form = inequality_form(program, settings.primal);
  if (!form) return {.status = LpStatus::kFailed};
  LpSolution solution;
  std::vector<double> x0;
  for (const int j : form->program_column) {
    const auto k = static_cast<std::size_t>(j);
    x0.push_back(std::clamp(0.0, program.lower[k], program.upper[k]));
  }
  Iteration iteration{*form, settings};
  iteration.start(x0);
  while (!iteration.converged()) {
    if (stop.stop_requested()) return {.status = LpStatus::kStopped, .iterations = solution.iterations};
    if (solution.iterations == settings.iterations || !iteration.step()) {
      return {.status = LpStatus::kFailed, .iterations = solution.iterations};
    }
    ++solution.iterations;
  }
  solution.status = LpStatus::kOptimal;
  solution.x = program.lower;
  for (std::size_t k = 0; k < form->cost.size(); ++k) {
    solution.x[static_cast<std::size_t>(form->program_column[k])] = iteration.x()[static_cast<Eigen::Index>(k)];
  }
  solution.dual.assign(program.bound.size(), 0.0);
  for (std::size_t r = 0; r < form->bound.size(); ++r) {
    if (form->program_row[r] != InequalityForm::kColumnBound) {
      solution.dual[static_cast<std::size_t>(form->program_row[r])] = iteration.z()[static_cast<Eigen::Index>(r)];
    }
  }
  solution.objective = std::inner_product(program.cost.begin(), program.cost.end(), solution.x.begin(), 0.0);
  return solution;
}

}  // namespace selvage::lp::interior_point
