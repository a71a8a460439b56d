// The pricing problem of column generation: the ratio of the least reduced cost.
#pragma once

#include <set>
#include <vector>

#include "core/planning/orders/ratio.h"

namespace selvage::planning::program {

// minimise  constant + sum over sizes of gain[s] a[s]
// so that   0 <= a[s] <= most[s],   1 <= sum of a[s] <= bundles,   sum of weight[s] a[s] <= capacity
struct PricingProblem {
  double constant{};
  std::vector<double> gain;  // negative: a bundle of this size lowers the reduced cost
  std::vector<int> most;
  int bundles{};
  std::vector<double> weight;  // at least 0
  double capacity{};
};

struct PricedRatios {
  std::vector<orders::Ratio> found;  // of negative cost and not among the known ones, each better than the one before
  double least{};                    // no ratio that is not known costs less
};

// Depth first over the sizes, most useful ones first, with bounds; after a limited number of nodes `least` is the bound
// that is left.
[[nodiscard]] PricedRatios price_ratios(const PricingProblem& problem, const std::set<orders::Ratio>& known);

}  // namespace selvage::planning::program
