#include "core/lp/interior_point/interior_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "core/lp/interior_point/border.h"
#include "core/lp/interior_point/division.h"
#include "core/lp/interior_point/domain.h"
#include "core/lp/interior_point/inequality_form.h"

namespace selvage::lp::interior_point {
namespace {

// Proximal weights of the columns, tried in turn, because near the end rounding can leave a matrix that needs a larger
// one.  They shorten the step but do not change the solution: its residuals are measured without them.
constexpr std::array<double, 4> kRho{1e-9, 1e-6, 1e-4, 1e-2};
// A column that only a distant bound limits moves by its cost divided by rho per iteration, so rho is reduced once
// everything else has converged.
constexpr double kRhoDecay = 0.1;
constexpr double kLeastRhoFactor = 1e-4;
constexpr double kRoundings = 4;  // roundings of the largest bound: steps meet no row more exactly,
constexpr double kMeasured = 16;  // and products of rows and columns are no more exact than this many
constexpr double kCentring = 3;   // exponent applied to the predicted ratio of the gaps, for the corrector's target
constexpr double kAcceptedViolation =
    5e-10;  // row violation allowed when the gap need not close completely; solve() accepts twice as much
constexpr double kClearlyBroken = 1e-6;  // a row violation that rounding cannot have made
constexpr double kFalls = 0.99;          // the largest row violation falls when it is below this part of the last one
constexpr double kDualPart = 1e-2;       // dual tolerance as a fraction of the tolerance of the gap
constexpr double kLeastCost = 1e-3;      // so that a program without costs has a central path as well

double roundings(double count, double of) {
  return count * std::numeric_limits<double>::epsilon() * of;
}

// The form of a domain of the program, or of the whole program where it is not divided, in terms of the program's
// columns and rows.
std::optional<InequalityForm> form_of(const LinearProgram& program, const Division& division, std::size_t domain,
                                      double tolerance) {
  if (division.domains.empty()) return inequality_form(program, tolerance);
  auto form = inequality_form(domain_program(program, division, domain), tolerance);
  if (!form) return form;
  for (int& column : form->program_column) column = division.domains[domain].columns[static_cast<std::size_t>(column)];
  for (int& row : form->program_row) {
    if (row != InequalityForm::kColumnBound) row = division.domains[domain].rows[static_cast<std::size_t>(row)];
  }
  return form;
}

// The iteration over all domains.  The stages of a step that only concern a domain are executed by several threads;
// sums are taken in the order of the domains.
class Iteration {
 public:
  Iteration(const LinearProgram& program, const InteriorPointSettings& settings, const Executor& executor,
            const std::stop_token& stop)
      : program_{program},
        settings_{settings},
        executor_{executor},
        stop_{stop},
        division_{division(program, settings.domain_size)},
        domains_(std::max<std::size_t>(1, division_.domains.size())) {}

  // False when a row without columns requires too much: the program is infeasible.
  [[nodiscard]] bool start();
  [[nodiscard]] bool converged();
  // After converged(): the prices prove that every point within reach clearly breaks some row.
  [[nodiscard]] bool is_infeasible() const;
  // After converged(): the gap has been closed for some iterations, but the row violations no longer fall.
  [[nodiscard]] bool has_stalled() const { return stalls_ >= settings_.stalls; }
  [[nodiscard]] bool step();  // false when no further step is possible, or when cancelled
  // The solution, which starts as the fixed columns.
  void extract(LpSolution& solution) const;

 private:
  template <class Stage>
  void for_each_domain(const Stage& stage) {
    if (domains_.size() == 1) return stage(0);
    executor_.for_each(domains_.size(), stage);
  }
  template <class Value>
  [[nodiscard]] auto of_each_domain(const Value& value) {
    std::vector<decltype(value(std::size_t{}))> values(domains_.size());
    for_each_domain([&](std::size_t d) { values[d] = value(d); });
    return values;
  }

  [[nodiscard]] Border make_border() const;
  [[nodiscard]] std::vector<double> start_of(const Domain& domain) const;
  [[nodiscard]] bool factorise();
  [[nodiscard]] Domain::Steps direction();
  [[nodiscard]] double dual_residual_on_border();

  const LinearProgram& program_;
  const InteriorPointSettings& settings_;
  const Executor& executor_;
  const std::stop_token& stop_;
  const Division division_;
  std::vector<std::unique_ptr<Domain>> domains_;
  std::optional<Border> border_;
  std::vector<double> on_border_;  // what the border is solved for
  double rows_{};
  double largest_cost_{}, largest_bound_{};
  double gap_{};                  // s . z
  double least_dual_{kInfinity};  // the smallest dual residual so far
  double primal_{};               // the largest row violation allowed
  double broken_{};               // the largest row violation now
  int stalls_{};                  // iterations in a row in which the gap was closed and `broken_` did not fall
  double rho_factor_{1};          // the factor applied to rho
};

bool Iteration::start() {
  for_each_domain([&](std::size_t d) {
    auto form = form_of(program_, division_, d, settings_.primal);
    if (!form) return;
    const int own = division_.domains.empty() ? form->columns() : division_.domains[d].own;
    domains_[d] = std::make_unique<Domain>(*std::move(form), own);
  });
  if (!std::ranges::all_of(domains_, [](const auto& domain) { return domain != nullptr; })) return false;
  border_.emplace(make_border());
  on_border_.resize(division_.border.size());
  for (const auto& domain : domains_) {
    largest_cost_ = std::max(largest_cost_, largest_of(domain->form().cost));
    largest_bound_ = std::max(largest_bound_, largest_of(domain->form().bound));
    rows_ += domain->form().rows();
  }
  primal_ = std::max(settings_.primal, roundings(kRoundings, largest_bound_));
  for_each_domain(
      [&](std::size_t d) { domains_[d]->start(start_of(*domains_[d]), std::max(largest_cost_, kLeastCost)); });
  return true;
}

Border Iteration::make_border() const {
  std::vector<Border::Member> members;
  for (std::size_t d = 0; d < division_.domains.size(); ++d) {
    members.push_back({&domains_[d]->normal(), domains_[d]->own(), division_.domains[d].border});
  }
  return {division_.border, members};
}

std::vector<double> Iteration::start_of(const Domain& domain) const {
  std::vector<double> x;
  x.reserve(domain.form().program_column.size());
  for (const int j : domain.form().program_column) {
    const auto k = static_cast<std::size_t>(j);
    x.push_back(std::clamp(0.0, program_.lower[k], program_.upper[k]));
  }
  return x;
}

double Iteration::dual_residual_on_border() {
  std::ranges::fill(on_border_, 0.0);
  for (std::size_t d = 0; d < division_.domains.size(); ++d) {
    const auto residuals = domains_[d]->dual_residuals();
    const std::vector<int>& border = division_.domains[d].border;
    for (std::size_t k = 0; k < border.size(); ++k) on_border_[static_cast<std::size_t>(border[k])] += residuals[k];
  }
  return largest_of(on_border_);
}

bool Iteration::converged() {
  gap_ = 0;
  double cost = 0;
  double primal = 0;
  double dual = dual_residual_on_border();
  for (const auto& domain : domains_) {
    const Domain::Measure& measure = domain->measure();
    gap_ += measure.gap;
    cost += measure.cost;
    primal = std::max(primal, measure.primal);
    dual = std::max(dual, measure.dual);
  }
  dual /= 1 + largest_cost_;
  const bool stalled = dual > least_dual_ / 2;
  least_dual_ = std::min(least_dual_, dual);
  const bool closed = gap_ <= settings_.gap * (1 + std::abs(cost));
  if (closed && stalled) rho_factor_ = std::max(kLeastRhoFactor, kRhoDecay * rho_factor_);
  stalls_ = closed && primal > primal_ && primal > kFalls * broken_ ? stalls_ + 1 : 0;
  broken_ = primal;
  if (!closed || primal > primal_) return false;
  if (dual > settings_.dual && !(stalled && dual <= settings_.dual_when_stalled)) return false;
  const auto measured = of_each_domain([&](std::size_t d) { return domains_[d]->measure_primal(); });
  return std::ranges::max(measured) <= std::max(primal_, roundings(kMeasured, largest_bound_));
}

bool Iteration::is_infeasible() const {
  if (broken_ <= primal_ || !std::isfinite(settings_.reach)) return false;
  Domain::Proof sum;
  for (const double residual : on_border_) sum.columns += std::abs(residual);
  for (const auto& domain : domains_) {
    const Domain::Proof proof = domain->proof();
    sum = {sum.bound + proof.bound, sum.prices + proof.prices, sum.columns + proof.columns};
  }
  return sum.bound - settings_.reach * sum.columns > kClearlyBroken * sum.prices;
}

bool Iteration::factorise() {
  return std::any_of(kRho.begin(), kRho.end(), [&](double rho) {
    rho *= rho_factor_;
    const auto positive =
        of_each_domain([&](std::size_t d) { return static_cast<char>(domains_[d]->predict(rho, stop_)); });
    return std::ranges::find(positive, 0) == positive.end() && border_->factorise(rho, stop_);
  });
}

Domain::Steps Iteration::direction() {
  std::ranges::fill(on_border_, 0.0);
  const auto visit = [&](const auto& exchange) {
    for (std::size_t d = 0; d < division_.domains.size(); ++d) {
      const auto own = domains_[d]->direction_on_border();
      const std::vector<int>& border = division_.domains[d].border;
      for (std::size_t k = 0; k < border.size(); ++k) exchange(own[k], on_border_[static_cast<std::size_t>(border[k])]);
    }
  };
  visit([](double part, double& sum) { sum += part; });
  border_->solve(on_border_);
  visit([](double& part, double solved) { part = solved; });
  const auto longest = of_each_domain([&](std::size_t d) { return domains_[d]->direction(); });
  Domain::Steps steps = longest.front();
  for (const Domain::Steps& other : longest) {
    steps = {std::min(steps.primal, other.primal), std::min(steps.dual, other.dual)};
  }
  return steps;
}

bool Iteration::step() {
  if (!factorise()) return false;
  const double mu = gap_ / rows_;
  Domain::Steps steps = direction();
  steps = {std::min(1.0, steps.primal), std::min(1.0, steps.dual)};
  const auto gaps = of_each_domain([&](std::size_t d) { return domains_[d]->gap_after(steps); });
  const double affine = std::accumulate(gaps.begin(), gaps.end(), 0.0);
  const double sigma = std::pow(affine / gap_, kCentring);
  for_each_domain([&](std::size_t d) { domains_[d]->correct(sigma * mu); });
  steps = direction();
  // The iterates approach the boundary as the gap closes, but never reach it.
  const double keep = std::clamp(1 - mu, 0.99, 0.9995);
  steps = {std::min(1.0, keep * steps.primal), std::min(1.0, keep * steps.dual)};
  const auto finite = of_each_domain([&](std::size_t d) { return static_cast<char>(domains_[d]->advance(steps)); });
  return std::ranges::find(finite, 0) == finite.end();
}

void Iteration::extract(LpSolution& solution) const {
  solution.x = program_.lower;
  solution.dual.assign(program_.bound.size(), 0.0);
  for (const auto& domain : domains_) {
    const InequalityForm& form = domain->form();
    for (int k = 0; k < form.columns(); ++k) {
      solution.x[static_cast<std::size_t>(form.program_column[static_cast<std::size_t>(k)])] = domain->x(k);
    }
    for (int r = 0; r < form.rows(); ++r) {
      const int row = form.program_row[static_cast<std::size_t>(r)];
      if (row != InequalityForm::kColumnBound) solution.dual[static_cast<std::size_t>(row)] = domain->z(r);
    }
  }
  solution.objective = std::inner_product(program_.cost.begin(), program_.cost.end(), solution.x.begin(), 0.0);
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
                                   std::stop_token stop, const Executor& executor) {
  Iteration iteration{program, settings, executor, stop};
  if (!iteration.start()) return {.status = LpStatus::kFailed};
  LpSolution solution;
  while (!iteration.converged()) {
    if (stop.stop_requested()) return {.status = LpStatus::kStopped, .iterations = solution.iterations};
    if (iteration.is_infeasible()) return {.status = LpStatus::kInfeasible, .iterations = solution.iterations};
    if (solution.iterations == settings.iterations || iteration.has_stalled() || !iteration.step()) {
      return {.status = stop.stop_requested() ? LpStatus::kStopped : LpStatus::kFailed,
              .iterations = solution.iterations};
    }
    ++solution.iterations;
  }
  solution.status = LpStatus::kOptimal;
  iteration.extract(solution);
  return solution;
}

}  // namespace selvage::lp::interior_point
