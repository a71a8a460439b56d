#include "core/lp/interior_point/domain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lp/linear_program.h"

namespace selvage::lp::interior_point {
namespace {

constexpr double kDelta = 1e-11;  // proximal weight of the row multipliers
constexpr double kLeastStartingSlack = 1;

template <class Array>
std::span<double> span_of(Array& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

template <class Array>
double largest_in(const Array& v) {
  return v.size() == 0 ? 0 : v.abs().maxCoeff();
}

double dot(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) {
  return a.matrix().dot(b.matrix());
}

// The step length at which the first entry of v reaches zero; infinite when none decreases.
double longest_step(const Eigen::ArrayXd& v, const Eigen::ArrayXd& dv) {
  const double shrinks = v.size() == 0 ? 0 : (-dv / v).maxCoeff();
  return shrinks > 0 ? 1 / shrinks : kInfinity;
}

}  // namespace

double largest_of(std::span<const double> v) {
  return largest_in(Eigen::Map<const Eigen::ArrayXd>(v.data(), static_cast<Eigen::Index>(v.size())));
}

Domain::Domain(InequalityForm form, int own)
    : form_{std::move(form)},
      own_{own},
      rows_{row_runs(form_)},
      normal_{rows_, own},
      bound_{form_.bound.data(), form_.rows()} {
  cost_.setZero(form_.columns() + 1);
  std::copy(form_.cost.begin(), form_.cost.end(), cost_.data());
  for (Vector* v : {&x_, &dx_, &rd_}) v->setZero(form_.columns() + 1);
  form_.drop_matrix();
  for (Vector* v : {&s_, &z_, &ds_, &dz_, &rp_, &weight_, &target_, &wanted_}) v->setZero(form_.rows());
}

void Domain::start(std::span<const double> x, double product) {
  std::copy(x.begin(), x.end(), x_.data());
  multiply(rows_, span_of(x_), span_of(s_));
  s_ = (s_ - bound_).max(kLeastStartingSlack);
  z_ = product / s_;
  (void)measure_primal();
  measure_all();
}

double Domain::measure_primal() {
  multiply(rows_, span_of(x_), span_of(rp_));
  rp_ = bound_ + s_ - rp_;
  return largest_in(rp_);
}

void Domain::measure_all() {
  multiply_transposed(rows_, span_of(z_), span_of(rd_));
  rd_ = cost_ - rd_;
  rd_[rows_.zero_column()] = 0;
  measure_ = {dot(s_, z_), dot(cost_, x_), largest_in(rp_), largest_in(rd_.head(own_))};
}

Domain::Proof Domain::proof() const {
  return {dot(bound_, z_), z_.sum(), cost_.abs().sum() + rd_.head(own_).abs().sum()};
}

bool Domain::predict(double rho, const std::stop_token& stop) {
  weight_ = z_ / (s_ + kDelta * z_);
  if (!normal_.factorise(span_of(weight_), rho, stop)) return false;
  target_ = -s_ * z_;
  start_direction();
  return true;
}

void Domain::correct(double product) {
  target_ = product - s_ * z_ - ds_ * dz_;
  start_direction();
}

// Solves A dx - ds + delta dz = rp, A^T dz - rho dx = rd, s dz + z ds = target for (dx, ds, dz), up to the point where
// the border's part of the solution is needed.
void Domain::start_direction() {
  wanted_ = rp_ + target_ / z_;
  dz_ = weight_ * wanted_;
  multiply_transposed(rows_, span_of(dz_), span_of(dx_));
  dx_ -= rd_;
  normal_.solve_lower(span_of(dx_));
}

// The rest of the solution, once the border's part is known.
Domain::Steps Domain::direction() {
  normal_.solve_upper(span_of(dx_));
  dx_[rows_.zero_column()] = 0;
  multiply(rows_, span_of(dx_), span_of(ds_));
  dz_ = weight_ * (wanted_ - ds_);
  ds_ += kDelta * dz_ - rp_;
  return {longest_step(s_, ds_), longest_step(z_, dz_)};
}

double Domain::gap_after(Steps steps) const {
  return ((s_ + steps.primal * ds_) * (z_ + steps.dual * dz_)).sum();
}

bool Domain::advance(Steps steps) {
  x_ += steps.primal * dx_;
  s_ += steps.primal * ds_;
  z_ += steps.dual * dz_;
  rp_ -= steps.primal * (rp_ - kDelta * dz_);
  if (!std::isfinite(dot(x_, x_))) return false;
  measure_all();
  return true;
}

}  // namespace selvage::lp::interior_point
