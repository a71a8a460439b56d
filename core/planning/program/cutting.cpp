#include "core/planning/program/cutting.h"

#include <algorithm>
#include <numeric>

#include "core/planning/program/remnants.h"

namespace selvage::planning::program {

Price price_of(const orders::Problem& problem, const Candidate& candidate) {
  const orders::Costs& costs = problem.costs;
  Price price;
  price.unit = problem.roll_rate() * problem.unit_length(candidate.length) + problem.plies_of_unit() * costs.ply;
  price.lay = costs.lay + problem.cut_rate() * perimeter_of(problem.order, candidate.ratio);
  price.marker = costs.marker;
  for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour) {
    price.most.push_back(most_units(problem, candidate.ratio, colour));
    price.most_units += price.most.back();
  }
  return price;
}

bool fits_table(const orders::Problem& problem, double length) {
  return length + problem.cloth.end_loss <= problem.limits.table;
}

int lays_of(const orders::Problem& problem, const Use& use) {
  const int units = std::accumulate(use.units.begin(), use.units.end(), 0);
  return (units + problem.units_of_lay() - 1) / problem.units_of_lay();
}

double cost_of(const orders::Problem& problem, const Use& use) {
  const Price price = price_of(problem, use.candidate);
  const int units = std::accumulate(use.units.begin(), use.units.end(), 0);
  return price.unit * units + price.lay * lays_of(problem, use) + price.marker;
}

double cost_of(const orders::Problem& problem, const std::vector<Use>& uses) {
  double cost = 0;
  for (const Use& use : uses) cost += cost_of(problem, use);
  return cost - problem.remnant_saving() * spread_on_remnants(problem, uses).length;
}

double cloth_of(const orders::Problem& problem, const std::vector<Use>& uses) {
  double cloth = 0;
  for (const Use& use : uses) {
    const int units = std::accumulate(use.units.begin(), use.units.end(), 0);
    cloth += units * problem.unit_length(use.candidate.length);
  }
  return cloth;
}

std::vector<std::vector<int>> delivered_by(const orders::Problem& problem, const std::vector<Use>& uses) {
  const std::size_t colours = problem.order.colours.size(), sizes = problem.order.sizes.size();
  std::vector<std::vector<int>> delivered(colours, std::vector<int>(sizes));
  for (const Use& use : uses) {
    for (std::size_t colour = 0; colour < colours; ++colour) {
      for (std::size_t size = 0; size < sizes; ++size)
        delivered[colour][size] += problem.plies_of_unit() * use.units[colour] * use.candidate.ratio[size];
    }
  }
  return delivered;
}

bool delivers(const orders::Problem& problem, const std::vector<Use>& uses) {
  const auto delivered = delivered_by(problem, uses);
  for (std::size_t colour = 0; colour < delivered.size(); ++colour) {
    for (std::size_t size = 0; size < delivered[colour].size(); ++size) {
      const int garments = delivered[colour][size];
      if (garments < problem.least(colour, size) || garments > problem.most(colour, size)) return false;
    }
  }
  return true;
}

}  // namespace selvage::planning::program
