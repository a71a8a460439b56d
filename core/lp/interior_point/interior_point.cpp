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

// Proximal weights of the columns, tried in turn, because near the end rounding can leave a matrix that needs a larger
// one.  They shorten the step but do not change the solution: its residuals are measured without them.
constexpr std::array<double, 4> kRho{1e-9, 1e-6, 1e-4, 1e-2};
// A column that only a distant bound limits moves by its cost divided by rho per iteration, so rho is reduced once
// everything else has converged.
constexpr double kRhoDecay = 0.1;
constexpr double kLeastRhoFactor = 1e-4;
constexpr double kRoundings = 4;  // roundings of the largest bound: steps meet no row more exactly,
constexpr double kMeasured = 16;  // and products of rows and columns are no more exact than this many
constexpr double kDelta = 1e-11;  // proximal weight of the row multipliers
constexpr double kLeastStartingSlack = 1;
constexpr double kCentring = 3;  // exponent applied to the predicted ratio of the gaps, for the corrector's target
constexpr double kAcceptedViolation =
    5e-10;  // row violation allowed when the gap need not close completely; solve() accepts twice as much
constexpr double kDualPart = 1e-2;   // dual tolerance as a fraction of the tolerance of the gap
constexpr double kLeastCost = 1e-3;  // so that a program without costs has a central path as well

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

double roundings(double count, double of) {
  return count * std::numeric_limits<double>::epsilon() * of;
}

// The step length at which the first entry of v reaches zero; infinite when none decreases.
double longest_step(const Vector& v, const Vector& dv) {
  const double shrinks = v.size() == 0 ? 0 : (-dv / v).maxCoeff();
  return shrinks > 0 ? 1 / shrinks : kInfinity;
}

// The iteration for min c.x with A x - s = b, s >= 0, and the dual A^T z = c, z >= 0.  Vectors over columns end with
// the zero column of RowRuns, which is 0 in all of them.
class Iteration {
 public:
  Iteration(const InequalityForm& form, const InteriorPointSettings& settings, const std::stop_token& stop)
      : rows_{row_runs(form)},
        settings_{settings},
        stop_{stop},
        normal_{rows_},
        cost_{vector_of(form.cost)},
        bound_{vector_of(form.bound)},
        largest_cost_{largest(cost_)} {
    primal_ = std::max(settings.primal, roundings(kRoundings, largest(bound_)));
    cost_.conservativeResize(form.columns() + 1);
    cost_[form.columns()] = 0;
    for (Vector* v : {&x_, &dx_, &rd_}) v->setZero(form.columns() + 1);
    for (Vector* v : {&s_, &z_, &ds_, &dz_, &rp_, &weight_, &target_, &wanted_}) v->setZero(form.rows());
  }

  void start(std::span<const double> x);
  bool converged();
  bool step();  // false when no further step is possible, or when cancelled

  [[nodiscard]] const Vector& x() const { return x_; }
  [[nodiscard]] const Vector& z() const { return z_; }

 private:
  bool factorise();
  void measure_primal();
  void direction();

  const RowRuns rows_;
  const InteriorPointSettings& settings_;
  const std::stop_token& stop_;
  NormalEquations normal_;
  Vector cost_, bound_;
  double largest_cost_;
  Vector x_, s_, z_, dx_, ds_, dz_;
  Vector rp_, rd_;                // the residuals of A x - s = b and of A^T z = c
  Vector weight_;                 // 1 / (s / z + delta)
  Vector target_;                 // the target value of s dz + z ds
  Vector wanted_;                 // the target value of A dx where the weight is large
  double gap_{};                  // s . z
  double least_dual_{kInfinity};  // the smallest dual residual so far
  double primal_{};               // the largest row violation allowed
  double rho_factor_{1};          // the factor applied to rho
};

void Iteration::start(std::span<const double> x) {
  std::copy(x.begin(), x.end(), x_.data());
  multiply(rows_, span_of(x_), span_of(s_));
  s_ = (s_ - bound_).max(kLeastStartingSlack);
  z_ = std::max(largest_cost_, kLeastCost) / s_;  // all products s z are equal: on the central path
  measure_primal();
}

void Iteration::measure_primal() {
  multiply(rows_, span_of(x_), span_of(rp_));
  rp_ = bound_ + s_ - rp_;
}

bool Iteration::converged() {
  multiply_transposed(rows_, span_of(z_), span_of(rd_));
  rd_ = cost_ - rd_;
  rd_[rows_.zero_column()] = 0;
  gap_ = dot(s_, z_);
  const double dual = largest(rd_) / (1 + largest_cost_);
  const bool stalled = dual > least_dual_ / 2;
  least_dual_ = std::min(least_dual_, dual);
  const bool closed = gap_ <= settings_.gap * (1 + std::abs(dot(cost_, x_)));
  if (closed && stalled) rho_factor_ = std::max(kLeastRhoFactor, kRhoDecay * rho_factor_);
  if (!closed || largest(rp_) > primal_) return false;
  if (dual > settings_.dual && !(stalled && dual <= settings_.dual_when_stalled)) return false;
  measure_primal();  // steps only update the residual, so it has gathered rounding errors
  return largest(rp_) <= std::max(primal_, roundings(kMeasured, largest(bound_)));
}

bool Iteration::factorise() {
  weight_ = z_ / (s_ + kDelta * z_);
  return std::any_of(kRho.begin(), kRho.end(),
                     [&](double rho) { return normal_.factorise(span_of(weight_), rho_factor_ * rho, stop_); });
}

// (dx, ds, dz) with A dx - ds + delta dz = rp, A^T dz - rho dx = rd, s dz + z ds = target.
void Iteration::direction() {
  wanted_ = rp_ + target_ / z_;
  dz_ = weight_ * wanted_;
  multiply_transposed(rows_, span_of(dz_), span_of(dx_));
  dx_ -= rd_;
  normal_.solve(span_of(dx_));
  dx_[rows_.zero_column()] = 0;
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
  // The iterates approach the boundary as the gap closes, but never reach it.
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

double attainable_violation(const LinearProgram& program) {
  double most = 0;
  for (const std::vector<double>* bounds : {&program.bound, &program.lower, &program.upper}) {
    for (const double bound : *bounds) {
      if (std::isfinite(bound)) most = std::max(most, std::abs(bound));
    }
  }
  return roundings(kMeasured, most);
}

InteriorPointSettings settings_for_tolerance(double tolerance) {
  InteriorPointSettings settings;
  if (tolerance <= settings.gap) return settings;
  settings.gap = tolerance;
  settings.primal = std::max(settings.primal, kAcceptedViolation);
  settings.dual = std::max(settings.dual, kDualPart * tolerance);
  settings.dual_when_stalled = std::max(settings.dual_when_stalled, settings.dual);
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
  Iteration iteration{*form, settings, stop};
  iteration.start(x0);
  while (!iteration.converged()) {
    if (stop.stop_requested()) return {.status = LpStatus::kStopped, .iterations = solution.iterations};
    if (solution.iterations == settings.iterations || !iteration.step()) {
      return {.status = stop.stop_requested() ? LpStatus::kStopped : LpStatus::kFailed,
              .iterations = solution.iterations};
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
