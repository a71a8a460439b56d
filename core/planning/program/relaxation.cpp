#include "core/planning/program/relaxation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/lp/solver/solve.h"
#include "core/planning/program/cutting_program.h"
#include "core/planning/program/generation.h"
#include "core/planning/program/remnants.h"

namespace selvage::planning::program {
namespace {

using Entry = lp::LinearProgram::Entry;

constexpr int kGenerations = 200;           // rounds of column generation
constexpr double kPricingTolerance = 1e-7;  // of the bound: reduced costs above minus this end the generation

// The rows of the program: two for each colour and size that is ordered, then one for each colour with remnants.
struct Delivery {
  std::size_t colour{}, size{};
};
std::vector<Delivery> deliveries_of(const orders::Problem& problem) {
  std::vector<Delivery> deliveries;
  for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour) {
    for (std::size_t size = 0; size < problem.order.sizes.size(); ++size) {
      if (problem.order.garments[colour][size] > 0) deliveries.push_back({colour, size});
    }
  }
  return deliveries;
}

// The relaxed cost of a unit of plies, without what the marker's length and perimeter add to it for generated ratios.
double relaxed_unit(const orders::Problem& problem, const Price& price) {
  return price.unit + price.lay / problem.units_of_lay() + price.marker / std::max(1, price.most_units);
}

class Master {
 public:
  Master(const orders::Problem& problem, std::stop_token stop)
      : problem_{problem}, stop_{std::move(stop)}, deliveries_{deliveries_of(problem)} {}

  void add(const Candidate& candidate) {
    prices_.push_back(price_of(problem_, candidate));
    candidates_.push_back(candidate);
  }

  bool solve() {
    const lp::LinearProgram program = this->program();
    if (program.columns() == 0) return false;
    lp::LpSolution solution = lp::solver::solve(program, lp::solver::SolverChoice::kSimplex, {}, stop_);
    if (solution.status != lp::LpStatus::kOptimal) return false;
    bound_ = solution.objective;
    worth_.assign(problem_.order.colours.size(), std::vector<double>(problem_.order.sizes.size()));
    for (std::size_t k = 0; k < deliveries_.size(); ++k) {
      const auto [colour, size] = deliveries_[k];
      worth_[colour][size] = problem_.plies_of_unit() * (solution.dual[2 * k] - solution.dual[2 * k + 1]);
    }
    saved_.assign(problem_.order.colours.size(), 0);
    std::size_t row = 2 * deliveries_.size();
    for (std::size_t colour = 0; colour < saved_.size(); ++colour) {
      if (has_remnants(colour)) saved_[colour] = solution.dual[row++];
    }
    return true;
  }

  [[nodiscard]] double bound() const { return bound_; }
  // The rate at which the bound rises with the units of plies that deliver one bundle of this size.
  [[nodiscard]] double worth(std::size_t colour, std::size_t size) const { return worth_[colour][size]; }
  // What a millimetre of a ply of this colour saves at most, because remnants are still to be had.
  [[nodiscard]] double saved(std::size_t colour) const { return saved_[colour]; }
  [[nodiscard]] const std::vector<Candidate>& candidates() const { return candidates_; }

  // What a cutting that uses the candidate costs beyond the bound.  With X units in all, that is at least X times the
  // least reduced cost, and what the relaxation left out of the lays and the marker; the least of it is at one unit, at
  // full lays, or at the most units.
  [[nodiscard]] double extra(std::size_t candidate) const {
    const Price& price = prices_[candidate];
    if (price.most_units == 0) return lp::kInfinity;
    double reduced = lp::kInfinity;
    for (std::size_t colour = 0; colour < price.most.size(); ++colour) {
      if (price.most[colour] == 0) continue;
      double cost =
          relaxed_unit(problem_, price) - saved_[colour] * problem_.unit_length(candidates_[candidate].length);
      for (std::size_t size = 0; size < problem_.order.sizes.size(); ++size)
        cost -= candidates_[candidate].ratio[size] * worth_[colour][size];
      reduced = std::min(reduced, cost);
    }
    reduced = std::max(0.0, reduced);
    const int per_lay = problem_.units_of_lay();
    const auto at = [&](int units) {
      const int lays = (units + per_lay - 1) / per_lay;
      return units * reduced + price.lay * (lays - 1.0 * units / per_lay) +
             price.marker * (1 - 1.0 * units / price.most_units);
    };
    double extra = std::min(at(1), at(price.most_units));
    for (int units = per_lay; units < price.most_units; units += per_lay) extra = std::min(extra, at(units));
    return std::max(0.0, extra);
  }

 private:
  [[nodiscard]] lp::LinearProgram program() const {
    lp::LinearProgram program;
    std::vector<std::vector<int>> columns;  // by candidate, by colour; -1: none
    for (const Price& price : prices_) {
      std::vector<int>& own = columns.emplace_back(price.most.size(), -1);
      for (std::size_t colour = 0; colour < price.most.size(); ++colour) {
        if (price.most[colour] > 0)
          own[colour] = program.add_column(relaxed_unit(problem_, price), 0, price.most[colour]);
      }
    }
    for (const auto [colour, size] : deliveries_) {
      std::vector<Entry> row;
      for (std::size_t k = 0; k < candidates_.size(); ++k) {
        const int bundles = candidates_[k].ratio[size];
        if (columns[k][colour] >= 0 && bundles > 0)
          row.push_back({columns[k][colour], 1.0 * bundles * problem_.plies_of_unit()});
      }
      program.add_row(row, problem_.least(colour, size));
      for (Entry& entry : row) entry.value = -entry.value;
      program.add_row(row, -problem_.most(colour, size));
    }
    add_remnants(program, columns);
    return program;
  }

  [[nodiscard]] bool has_remnants(std::size_t colour) const {
    return problem_.remnant_saving() > 0 && remnant_length(problem_, colour) > 0;
  }
  // The remnants of a colour as one length, of which no more is used than the plies take.
  void add_remnants(lp::LinearProgram& program, const std::vector<std::vector<int>>& columns) const {
    for (std::size_t colour = 0; colour < problem_.order.colours.size(); ++colour) {
      if (!has_remnants(colour)) continue;
      const int used = program.add_column(-problem_.remnant_saving(), 0, remnant_length(problem_, colour));
      std::vector<Entry> row{{used, -1}};
      for (std::size_t k = 0; k < candidates_.size(); ++k) {
        if (columns[k][colour] >= 0) row.push_back({columns[k][colour], problem_.unit_length(candidates_[k].length)});
      }
      program.add_row(row, 0);
    }
  }

  const orders::Problem& problem_;
  std::stop_token stop_;
  std::vector<Delivery> deliveries_;
  std::vector<Candidate> candidates_;
  std::vector<Price> prices_;
  double bound_{};
  std::vector<std::vector<double>> worth_;  // by colour, by size
  std::vector<double> saved_;               // by colour
};

Relaxation relaxation_of(const Master& master) {
  Relaxation relaxation{.solved = true, .bound = master.bound(), .candidates = master.candidates()};
  for (std::size_t k = 0; k < relaxation.candidates.size(); ++k) relaxation.extra.push_back(master.extra(k));
  return relaxation;
}

// Which ratios of a colour have a negative reduced cost.  The marker's cost is spread over more units than any marker
// may have, so that the price is linear and never too high.
PricingProblem pricing_of(const orders::Problem& problem, const Estimated& estimated, const Master& master,
                          std::size_t colour) {
  const orders::Order& order = problem.order;
  const orders::LengthEstimate& estimate = estimated.lengths;
  const int unit = problem.plies_of_unit(), per_lay = problem.units_of_lay();
  const double rate = problem.roll_rate() - master.saved(colour), cut_rate = problem.cut_rate();
  int most_units = 0;
  for (std::size_t c = 0; c < order.colours.size(); ++c) {
    int most = 0;
    for (std::size_t size = 0; size < order.sizes.size(); ++size) most = std::max(most, problem.most(c, size) / unit);
    most_units += most;
  }
  PricingProblem pricing;
  pricing.constant = rate * problem.unit_length(estimate.length_of_ends()) + unit * problem.costs.ply +
                     problem.costs.lay / per_lay + problem.costs.marker / std::max(1, most_units);
  pricing.bundles = problem.limits.bundles;
  pricing.capacity = problem.limits.table + estimated.beyond - problem.cloth.end_loss - estimate.length_of_ends();
  for (std::size_t size = 0; size < order.sizes.size(); ++size) {
    pricing.weight.push_back(estimate.length_per_area() * order.sizes[size].area);
    pricing.gain.push_back(unit * rate * pricing.weight.back() + cut_rate * order.sizes[size].perimeter / per_lay -
                           master.worth(colour, size));
    pricing.most.push_back(problem.most(colour, size) / unit);
  }
  return pricing;
}

// The most units of plies that can be cut of a colour.
int units_of_colour(const orders::Problem& problem, std::size_t colour) {
  int units = 0;
  for (std::size_t size = 0; size < problem.order.sizes.size(); ++size)
    units += problem.most(colour, size) / problem.plies_of_unit();
  return units;
}

}  // namespace

Relaxation relax(const orders::Problem& problem, std::vector<Candidate> candidates, std::stop_token stop) {
  Master master{problem, std::move(stop)};
  for (const Candidate& candidate : candidates) master.add(candidate);
  if (!master.solve()) return {.candidates = std::move(candidates)};
  return relaxation_of(master);
}

std::optional<double> bound_with(const orders::Problem& problem, std::vector<Candidate> candidates, int fewest,
                                 std::stop_token stop) {
  const CuttingProgram program{problem, std::move(candidates), fewest};
  const lp::LpSolution solution =
      lp::solver::solve(program.program().linear, lp::solver::SolverChoice::kSimplex, {}, std::move(stop));
  if (solution.status == lp::LpStatus::kInfeasible) return lp::kInfinity;
  if (solution.status != lp::LpStatus::kOptimal) return std::nullopt;
  return solution.objective;
}

Relaxation relax_by_generation(const orders::Problem& problem, const std::vector<Candidate>& candidates,
                               const Estimated& estimated, const std::vector<orders::Ratio>& closed,
                               std::stop_token stop) {
  Master master{problem, stop};
  std::set<orders::Ratio> known{closed.begin(), closed.end()};
  for (const Candidate& candidate : candidates) {
    master.add(candidate);
    known.insert(candidate.ratio);
  }
  for (int round = 0;; ++round) {
    if (stop.stop_requested() || !master.solve()) return {.candidates = master.candidates()};
    double missing = 0, least = lp::kInfinity;  // what more candidates may lower the bound by
    std::vector<orders::Ratio> found;
    for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour) {
      PricedRatios priced = price_ratios(pricing_of(problem, estimated, master, colour), known);
      missing += std::min(0.0, priced.least) * units_of_colour(problem, colour);
      least = std::min(least, priced.least);
      found.insert(found.end(), priced.found.begin(), priced.found.end());
    }
    if (round == kGenerations || found.empty() || -missing <= kPricingTolerance * std::abs(master.bound())) {
      Relaxation relaxation = relaxation_of(master);
      relaxation.bound += missing;
      relaxation.extra_of_others = std::max(0.0, least);
      return relaxation;
    }
    for (orders::Ratio& ratio : found) {
      if (!known.insert(ratio).second) continue;
      const double length = estimated.lengths.length_of(area_of(problem.order, ratio));
      master.add({std::move(ratio), length});
    }
  }
}

}  // namespace selvage::planning::program
