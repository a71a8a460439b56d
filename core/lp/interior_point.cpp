#include "core/lp/interior_point.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/lp/inequality_form.h"
#include "core/lp/normal_equations.h"

namespace selvage {
namespace {

using Vector = std::vector<double>;

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
    const auto n = static_cast<std::size_t>(form.columns()), m = static_cast<std::size_t>(form.rows());
    for (Vector* v : {&x_, &dx_, &rd_, &scratch_x_}) v->assign(n, 0.0);
    for (Vector* v : {&s_, &z_, &ds_, &dz_, &rp_, &weight_, &target_, &scratch_}) v->assign(m, 0.0);
  }

  void start(std::span<const double> x);
  bool converged();
  bool step();  // false when it can go no further

  std::span<const double> x() const { return x_; }
  std::span<const double> z() const { return z_; }
  void trace(int k) const { std::printf("%3d  p %.1e d %.1e gap %.1e obj %.12g\n", k, largest(rp_), largest(rd_), gap_, dot(form_.cost,x_)); }

 private:
  void direction();

  const InequalityForm& form_;
  const InteriorPointSettings& settings_;
  NormalEquations normal_;
  Vector x_, s_, z_, dx_, ds_, dz_;
  Vector rp_, rd_;      // what is missing from A x - s = b and from A^T z = c
  Vector weight_;       // 1 / (s/z + delta)
  Vector target_;       // what s dz + z ds is to be
  Vector scratch_, scratch_x_;
  double gap_{};        // s . z
  double rho_{}, delta_{};
};

void Iteration::start(std::span<const double> x) {
  std::copy(x.begin(), x.end(), x_.begin());
  multiply(form_, x_, s_);
  const double c0 = std::max(largest(form_.cost), 1e-3);
  const char* e = std::getenv("S0");
  const double s0 = e ? atof(e) : 1.0;
  const char* f = std::getenv("M0");
  const double m0 = f ? atof(f) : 1.0;
  for (std::size_t r = 0; r < s_.size(); ++r) {
    s_[r] = std::max(s_[r] - form_.bound[r], s0);
    z_[r] = m0 * c0 / s_[r];
  }
}

bool Iteration::converged() {
  multiply(form_, x_, rp_);
  for (std::size_t r = 0; r < rp_.size(); ++r) rp_[r] = form_.bound[r] + s_[r] - rp_[r];
  multiply_transposed(form_, z_, rd_);
  for (std::size_t j = 0; j < rd_.size(); ++j) rd_[j] = form_.cost[j] - rd_[j];
  gap_ = dot(s_, z_);
  return gap_ <= settings_.gap * (1 + std::abs(dot(form_.cost, x_))) && largest(rp_) <= settings_.primal &&
         largest(rd_) <= settings_.dual * (1 + largest(form_.cost));
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
    ds_[r] += delta_ * dz_[r] - rp_[r];
  }
}

bool Iteration::step() {
  const auto m = static_cast<double>(s_.size());
  rho_ = 1e-9;
  delta_ = 1e-11;
  for (std::size_t r = 0; r < s_.size(); ++r) weight_[r] = 1 / (s_[r] / z_[r] + delta_);
  if (!normal_.factorise(weight_, rho_)) return false;
  const double mu = gap_ / m;
  for (std::size_t r = 0; r < s_.size(); ++r) target_[r] = -s_[r] * z_[r];
  direction();
  double primal = longest_step(s_, ds_), dual = longest_step(z_, dz_);
  double affine = 0;
  for (std::size_t r = 0; r < s_.size(); ++r) affine += (s_[r] + primal * ds_[r]) * (z_[r] + dual * dz_[r]);
  const double sigma = std::pow(affine / gap_, 3);
  for (std::size_t r = 0; r < s_.size(); ++r) target_[r] = sigma * mu - s_[r] * z_[r] - ds_[r] * dz_[r];
  direction();
  const double towards = std::max(0.9, 1 - mu) ;
  const double keep = std::min(0.9995, std::max(towards, 0.99));
  primal = std::min(1.0, keep * longest_step(s_, ds_) );
  dual = std::min(1.0, keep * longest_step(z_, dz_));
  if (std::getenv("TRACE")) std::printf("   sigma %.2e ap %.6f ad %.6f\n", sigma, primal, dual);
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
    if (std::getenv("TRACE")) iteration.trace(solution.iterations);
    if (stop.stop_requested()) return {.status = LpStatus::kStopped, .iterations = solution.iterations};
    if (solution.iterations == settings.iterations || !iteration.step()) {
      return {.status = LpStatus::kFailed, .iterations = solution.iterations};
    }
    ++solution.iterations;
  }
  if (std::getenv("TRACE")) iteration.trace(solution.iterations);
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
