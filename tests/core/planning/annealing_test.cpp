#include "core/planning/cheapest/annealing.h"

#include <gtest/gtest.h>

#include "tests/core/planning/small_orders.h"

namespace selvage::planning::cheapest {
namespace {

using test::EveryCutting;
using test::Random;

Lengths made_lengths_of(const orders::Problem& problem) {
  return {test::all_candidates(problem), orders::LengthEstimate{problem.cloth.width}, true, {}};
}

// Small orders have few cuttings, so annealing usually finds the best of them.
TEST(Annealing, FindsTheCheapestCuttingOfMostSmallOrders) {
  Random random{21};
  int orders = 0, best = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const orders::Problem problem = test::small_order(random);
    const double least = EveryCutting{problem}.least_cost();
    if (least == std::numeric_limits<double>::infinity()) continue;
    ++orders;
    const auto found =
        anneal(problem, made_lengths_of(problem), {.markers = 4, .steps = 3000, .scale = least, .seed = 1});
    ASSERT_TRUE(found) << trial;
    EXPECT_TRUE(delivers(problem, found->uses));
    EXPECT_DOUBLE_EQ(found->cost, cost_of(problem, found->uses));
    EXPECT_GE(found->cost, least * (1 - 1e-9));
    if (found->cost <= least * (1 + 1e-9)) ++best;
  }
  EXPECT_GT(orders, 30);
  EXPECT_GT(best, orders * 3 / 4);
}

TEST(Annealing, UsesOnlyAllowedRatios) {
  Random random{22};
  orders::Problem problem = test::small_order(random);
  problem.limits.bundles = 2;
  const orders::Ratio forbidden = orders::single(problem.order.sizes.size(), 0);
  const Lengths lengths{{}, orders::LengthEstimate{problem.cloth.width}, false, {forbidden}};
  const auto found = anneal(problem, lengths, {.markers = 4, .steps = 2000, .scale = 100, .seed = 1});
  if (found) {
    for (const program::Use& use : found->uses) EXPECT_NE(use.candidate.ratio, forbidden);
  }
  const Lengths none{{}, orders::LengthEstimate{problem.cloth.width}, true, {}};
  EXPECT_FALSE(anneal(problem, none, {.markers = 4, .steps = 10, .scale = 100, .seed = 1}));
}

TEST(Annealing, RepeatsItselfAndStops) {
  Random random{23};
  const orders::Problem problem = test::small_order(random);
  const AnnealingSettings settings{.markers = 3, .steps = 500, .scale = 50, .seed = 7};
  EXPECT_EQ(anneal(problem, made_lengths_of(problem), settings), anneal(problem, made_lengths_of(problem), settings));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(anneal(problem, made_lengths_of(problem), settings, stop.get_token()));
}

// The garments of the largest order are more than an int counts: what they sum to is seen by the undefined behaviour
// sanitizer.
TEST(Annealing, CountsTheGarmentsOfTheLargestOrder) {
  const orders::Problem problem = test::largest_order();
  const AnnealingSettings settings{.markers = 2, .steps = 2, .scale = 1e9, .seed = 1};
  EXPECT_FALSE(anneal(problem, made_lengths_of(problem), settings)) << "two markers of one size each";
}

}  // namespace
}  // namespace selvage::planning::cheapest
