#include "core/lp/interior_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/lp/inequality_form.h"
#include "core/lp/normal_equations.h"

namespace selvage {
namespace {

using Vector = std::vector<double>;

// Proximal weights of the columns, tried in turn: near the end rounding can leave a matrix that needs more.  They hold
// the step back, they do not move the answer: its residuals are measured without them.
constexpr std::array<double, 4> kRho{1e-9, 1e-6, 1e-4, 1e-2};
// A column that only a far bound holds moves by its cost over rho at a time: once all else is settled rho gives way.
constexpr double kEasier = 0.1;
constexpr double kLeastEase = 1e-4;
constexpr double kRoundings = 4;  // of the largest bound: no row can be met more exactly than that
constexpr double kDelta = 1e-11;  // proximal weight of the rows' multipliers
constexpr double kLeastStartingSlack = 1;
constexpr double kLeastCost = 1e-3;  // a program without costs has a centre all the same

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

double largest(std::span<const double> a) {
  double most = 0;
  for (const double value : a) most = std::max(most, std::abs(value));
  return most;
}

// The longest step <= 1 that keeps v + step * dv >= 0.
double longest_step(std::span<const double> v, std::span<const double> dv) {
  double most = 1;
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (v[k] + most * dv[k] < 0) most = -v[k] / dv[k];
  }
  return most;
}

void advance(std::span<double> v, std::span<const double> dv, double step) {
  for (std::size_t k = 0; k < v.size(); ++k) v[k] += step * dv[k];
}

// min c.x with A x - s = b, s >= 0, and the dual A^T z = c, z >= 0.
class Iteration {
 public:
  Iteration(const InequalityForm& form, const InteriorPointSettings& settings)
      : form_{form}, settings_{settings}, normal_{form} {
    primal_ = std::max(settings.primal, kRoundings * std::numeric_limits<double>::epsilon() * largest(form.bound));
    const auto n = static_cast<std::size_t>(form.columns());
    const auto m = static_cast<std::size_t>(form.rows());
    for (Vector* v : {&x_, &dx_, &rd_}) v->assign(n, 0.0);
    for (Vector* v : {&s_, &z_, &ds_, &dz_, &rp_, &weight_, &target_, &scratch_}) v->assign(m, 0.0);
  }

  void start(std::span<const double> x);
  bool converged();
  bool step();  // false when it can go no further

  std::span<const double> x() const { return x_; }
  std::span<const double> z() const { return z_; }

 private:
  void direction();

  const InequalityForm& form_;
  const InteriorPointSettings& settings_;
  NormalEquations normal_;
  Vector x_, s_, z_, dx_, ds_, dz_;
  Vector rp_, rd_;  // what is missing from A x - s = b and from A^T z = c
  Vector weight_;   // 1 / (s / z + delta)
  Vector target_;   // what s dz + z ds is to be
  Vector scratch_;
  double gap_{};  // s . z
  double last_dual_{kInfinity};
  double primal_{};  // the most a row may be broken by
  double ease_{1};   // what rho is multiplied by
};

void Iteration::start(std::span<const double> x) {
  std::copy(x.begin(), x.end(), x_.begin());
  multiply(form_, x_, s_);
  const double cost = std::max(largest(form_.cost), kLeastCost);
  for (std::size_t r = 0; r < s_.size(); ++r) {
    s_[r] = std::max(s_[r] - form_.bound[r], kLeastStartingSlack);
    z_[r] = cost / s_[r];  // every product s z the same: the central path
  }
}

bool Iteration::converged() {
  multiply(form_, x_, rp_);
  for (std::size_t r = 0; r < rp_.size(); ++r) rp_[r] = form_.bound[r] + s_[r] - rp_[r];
  multiply_transposed(form_, z_, rd_);
  for (std::size_t j = 0; j < rd_.size(); ++j) rd_[j] = form_.cost[j] - rd_[j];
  gap_ = dot(s_, z_);
  const double dual = largest(rd_) / (1 + largest(form_.cost));
  const bool at_rest = dual > last_dual_ / 2;
  last_dual_ = dual;
  const bool closed = gap_ <= settings_.gap * (1 + std::abs(dot(form_.cost, x_)));
  if (closed && at_rest) ease_ = std::max(kLeastEase, kEasier * ease_);
  return closed && largest(rp_) <= primal_ && (dual <= settings_.dual || (at_rest && dual <= settings_.dual_at_rest));
}

// (dx, ds, dz) with A dx - ds + delta dz = rp, A^T dz - rho dx = rd, s dz + z ds = target.
void Iteration::direction() {
  for (std::size_t r = 0; r < rp_.size(); ++r) scratch_[r] = rp_[r] + target_[r] / z_[r];
  for (std::size_t r = 0; r < rp_.size(); ++r) dz_[r] = weight_[r] * scratch_[r];
  multiply_transposed(form_, dz_, dx_);
  for (std::size_t j = 0; j < dx_.size(); ++j) dx_[j] -= rd_[j];
  normal_.solve(dx_);
  multiply(form_, dx_, ds_);
  for (std::size_t r = 0; r < rp_.size(); ++r) {
    dz_[r] = weight_[r] * (scratch_[r] - ds_[r]);
    ds_[r] += kDelta * dz_[r] - rp_[r];
  }
}

bool Iteration::step() {
  const auto m = static_cast<double>(s_.size());
  for (std::size_t r = 0; r < s_.size(); ++r) weight_[r] = 1 / (s_[r] / z_[r] + kDelta);
  if (std::none_of(kRho.begin(), kRho.end(), [&](double rho) { return normal_.factorise(weight_, ease_ * rho); }))
    return false;
  const double mu = gap_ / m;
  for (std::size_t r = 0; r < s_.size(); ++r) target_[r] = -s_[r] * z_[r];
  direction();
  double primal = longest_step(s_, ds_);
  double dual = longest_step(z_, dz_);
  double affine = 0;
  for (std::size_t r = 0; r < s_.size(); ++r) affine += (s_[r] + primal * ds_[r]) * (z_[r] + dual * dz_[r]);
  const double sigma = std::pow(affine / gap_, 3);
  for (std::size_t r = 0; r < s_.size(); ++r) target_[r] = sigma * mu - s_[r] * z_[r] - ds_[r] * dz_[r];
  direction();
  // Nearer to the boundary as the gap closes, never onto it.
  const double keep = std::clamp(1 - mu, 0.99, 0.9995);
  primal = keep * longest_step(s_, ds_);
  dual = keep * longest_step(z_, dz_);
  advance(x_, dx_, primal);
  advance(s_, ds_, primal);
  advance(z_, dz_, dual);
  return std::isfinite(dot(x_, x_));
}

}  // namespace

LpSolution solve_by_interior_point(const LinearProgram& program, const InteriorPointSettings& settings,
                                   std::stop_token stop) {
  const auto form = inequality_form(program, settings.primal);
  if (!form) return {.status = LpStatus::kFailed};
  LpSolution solution;
  Vector x0;
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
    solution.x[static_cast<std::size_t>(form->program_column[k])] = iteration.x()[k];
  }
  solution.dual.assign(program.bound.size(), 0.0);
  for (std::size_t r = 0; r < form->bound.size(); ++r) {
    if (form->program_row[r] != InequalityForm::kColumnBound) {
      solution.dual[static_cast<std::size_t>(form->program_row[r])] = iteration.z()[r];
    }
  }
  solution.objective = dot(program.cost, solution.x);
  return solution;
}

}  // namespace selvage
