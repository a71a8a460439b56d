// The search for cuttings: against all cuttings of small orders, and the laws of its header.
#include "core/planning/cheapest/search.h"

#include <gtest/gtest.h>

#include "core/planning/program/cutting_program.h"
#include "core/planning/program/generation.h"
#include "core/planning/program/relaxation.h"
#include "tests/core/planning/small_orders.h"

namespace selvage::planning::cheapest {
namespace {

using namespace program;

using test::EveryCutting;
using test::Random;

Lengths lengths_of(const orders::Problem& problem) {
  return {test::all_candidates(problem), orders::LengthEstimate{problem.cloth.width}, true, {}};
}

SearchSettings to_the_end() {
  SearchSettings settings;
  settings.gap = 0;
  settings.tuning.last_nodes = 20'000;
  settings.tuning.annealing_steps = 200;
  return settings;
}

TEST(Search, AgreesWithEveryCutting) {
  Random random{1};
  int feasible = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const orders::Problem problem = test::small_order(random);
    const double least = EveryCutting{problem}.least_cost();
    const SearchResult found = search(problem, lengths_of(problem), to_the_end());
    ASSERT_EQ(found.cutting.has_value(), least < lp::kInfinity) << trial;
    EXPECT_EQ(found.infeasible, !found.cutting.has_value()) << trial;
    if (!found.cutting) continue;
    ++feasible;
    EXPECT_NEAR(found.cutting->cost, least, 1e-6 * least) << trial;
    EXPECT_LE(found.bound, least * (1 + 1e-9)) << trial;
    EXPECT_NEAR(found.bound, least, 1e-4 * least) << trial;
    EXPECT_TRUE(delivers(problem, found.cutting->uses));
    EXPECT_DOUBLE_EQ(found.cutting->cost, cost_of(problem, found.cutting->uses));
  }
  EXPECT_GT(feasible, 12);
}

TEST(Search, AgreesWithEveryCuttingWhereThereAreRemnants) {
  Random random{5};
  int feasible = 0;
  for (int trial = 0; trial < 20; ++trial) {
    orders::Problem problem = test::small_order_with_remnants(random);
    const double least = EveryCutting{problem}.least_cost();
    const SearchResult found = search(problem, lengths_of(problem), to_the_end());
    ASSERT_EQ(found.cutting.has_value(), least < lp::kInfinity) << trial;
    if (!found.cutting) continue;
    EXPECT_NEAR(found.cutting->cost, least, 1e-6 * (1 + least)) << trial;
    EXPECT_LE(found.bound, least + 1e-6 * (1 + least)) << trial;
    EXPECT_NEAR(found.bound, least, 1e-4 * (1 + least)) << trial;
    EXPECT_TRUE(delivers(problem, found.cutting->uses));
    problem.cloth.remnants.clear();
    if (EveryCutting{problem}.least_cost() > least + 1e-6) ++feasible;
  }
  EXPECT_GT(feasible, 6) << "remnants hardly ever save anything";
}

TEST(Search, CostsNoMoreWithMoreRatios) {
  Random random{2};
  for (int trial = 0; trial < 12; ++trial) {
    orders::Problem problem = test::small_order(random);
    problem.limits.bundles = 1;
    const SearchResult few = search(problem, lengths_of(problem), to_the_end());
    problem.limits.bundles = 2;
    const SearchResult more = search(problem, lengths_of(problem), to_the_end());
    if (!few.cutting) continue;
    ASSERT_TRUE(more.cutting);
    EXPECT_LE(more.cutting->cost, few.cutting->cost * (1 + 1e-9));
  }
}

TEST(Search, StopsAtItsStart) {
  Random random{3};
  orders::Problem problem = test::small_order(random);
  const SearchResult best = search(problem, lengths_of(problem), to_the_end());
  ASSERT_TRUE(best.cutting);
  std::stop_source stop;
  stop.request_stop();
  const SearchResult stopped = search(problem, lengths_of(problem), {}, best.cutting, stop.get_token());
  ASSERT_TRUE(stopped.cutting);
  EXPECT_EQ(*stopped.cutting, *best.cutting);
  EXPECT_FALSE(search(problem, lengths_of(problem), {}, {}, stop.get_token()).infeasible) << "nothing was proved";
}

// A larger order, on which the node limits are reached.
orders::Problem larger_order() {
  Random random{4};
  orders::Problem problem = test::small_order(random);
  problem.order.sizes.clear();
  problem.order.garments.assign(2, {});
  problem.order.colours = {"red", "blue"};
  for (int size = 0; size < 3; ++size) {
    problem.order.sizes.push_back({std::to_string(size), 1e6 + 1e5 * size, 9'000});
    problem.order.garments[0].push_back(5 + 3 * size);
    problem.order.garments[1].push_back(16 - 2 * size);
  }
  problem.cloth.spread = orders::Spread::kOneWay;
  problem.limits = {.plies = 12, .table = 12'000, .bundles = 3};
  problem.costs = {};
  return problem;
}

SearchSettings small_search() {
  SearchSettings settings;
  settings.tuning.nodes = settings.tuning.last_nodes = 15;
  settings.tuning.neighbourhoods = 1;
  settings.tuning.annealing_steps = 500;
  settings.tuning.set_work = 10'000;
  return settings;
}

TEST(Search, GivesTheSameAnswerAgain) {
  const orders::Problem problem = larger_order();
  const Lengths lengths{{}, orders::LengthEstimate{problem.cloth.width}, false, {}};
  const SearchResult one = search(problem, lengths, small_search()), other = search(problem, lengths, small_search());
  ASSERT_TRUE(one.cutting);
  EXPECT_EQ(*one.cutting, *other.cutting);
  EXPECT_EQ(one.bound, other.bound);
  EXPECT_EQ(one.near, other.near);
  EXPECT_TRUE(delivers(problem, one.cutting->uses));
  EXPECT_LE(one.bound, one.cutting->cost);
}

TEST(Search, GeneratesCandidatesInsteadOfListingThem) {
  const orders::Problem problem = larger_order();
  const Lengths lengths{{}, orders::LengthEstimate{problem.cloth.width}, false, {}};
  SearchSettings settings = small_search();
  const SearchResult listed = search(problem, lengths, settings);
  settings.most_listed = 10;
  const SearchResult generated = search(problem, lengths, settings);
  ASSERT_TRUE(listed.cutting && generated.cutting);
  EXPECT_LT(generated.candidates, listed.candidates);
  EXPECT_TRUE(delivers(problem, generated.cutting->uses));
  EXPECT_LE(generated.bound, listed.cutting->cost);
  EXPECT_LT(generated.cutting->cost, 1.05 * listed.cutting->cost);
}

TEST(Search, BoundsCuttingsWithRemnantsAlsoByGeneration) {
  orders::Problem problem = larger_order();
  const Lengths lengths{{}, orders::LengthEstimate{problem.cloth.width}, false, {}};
  const SearchResult without = search(problem, lengths, small_search());
  problem.cloth.remnants = {{0, 3'000}, {1, 2'500}, {1, 1'000'000}};
  for (const std::size_t most_listed : {kMostListed, std::size_t{10}}) {
    SearchSettings settings = small_search();
    settings.most_listed = most_listed;
    const SearchResult found = search(problem, lengths, settings);
    ASSERT_TRUE(without.cutting && found.cutting);
    EXPECT_LE(found.bound, found.cutting->cost);
    EXPECT_GT(found.bound, 0);
    EXPECT_LT(found.cutting->cost, without.cutting->cost);
    EXPECT_TRUE(delivers(problem, found.cutting->uses));
  }
}

TEST(Relaxation, GenerationProvesABoundForAllRatios) {
  const orders::Problem problem = larger_order();
  const orders::LengthEstimate estimate{problem.cloth.width};
  std::vector<Candidate> all, singles;
  orders::for_each_ratio(3, problem.limits.bundles, [&](const orders::Ratio& ratio) {
    all.push_back({ratio, estimate.length_of(area_of(problem.order, ratio))});
    if (orders::bundles_in(ratio) == 1) singles.push_back(all.back());
  });
  const Relaxation listed = relax(problem, all), generated = relax_by_generation(problem, singles, {estimate}, {});
  ASSERT_TRUE(listed.solved && generated.solved);
  EXPECT_LE(generated.bound, listed.bound + 1e-6 * listed.bound) << "its price of a marker is lower";
  EXPECT_GT(generated.bound, 0.99 * listed.bound);
}

TEST(Relaxation, GenerationAlsoGoesBeyondTheTable) {
  orders::Problem problem = larger_order();
  problem.limits.table = 2'300;
  const Estimated estimated{orders::LengthEstimate{problem.cloth.width}, 300};
  std::vector<Candidate> all, singles;
  bool beyond = false;
  orders::for_each_ratio(3, problem.limits.bundles, [&](const orders::Ratio& ratio) {
    const double length = estimated.lengths.length_of(area_of(problem.order, ratio));
    if (!fits_table(problem, length - estimated.beyond)) return;
    beyond = beyond || !fits_table(problem, length);
    all.push_back({ratio, length});
    if (orders::bundles_in(ratio) == 1) singles.push_back(all.back());
  });
  EXPECT_TRUE(beyond);
  const Relaxation listed = relax(problem, all), generated = relax_by_generation(problem, singles, estimated, {});
  const Relaxation within = relax_by_generation(problem, singles, {estimated.lengths}, {});
  ASSERT_TRUE(listed.solved && generated.solved && within.solved);
  EXPECT_LE(generated.bound, listed.bound + 1e-6 * listed.bound);
  EXPECT_GT(generated.bound, 0.99 * listed.bound);
  EXPECT_GT(within.bound, 1.001 * listed.bound);
}

// Every cutting that uses a candidate costs the bound and its extra at least.
TEST(Relaxation, ExtraIsALowerBound) {
  Random random{5};
  for (int trial = 0; trial < 30; ++trial) {
    orders::Problem problem = test::small_order(random);
    problem.limits.bundles = 2;
    const SearchResult best = search(problem, lengths_of(problem), to_the_end());
    if (!best.cutting) continue;
    const Relaxation relaxation = relax(problem, test::all_candidates(problem));
    for (std::size_t k = 0; k < relaxation.candidates.size(); ++k) {
      for (const Use& use : best.cutting->uses) {
        if (use.candidate.ratio != relaxation.candidates[k].ratio) continue;
        EXPECT_LE(relaxation.bound + relaxation.extra[k], best.cutting->cost * (1 + 1e-7));
      }
    }
  }
}

TEST(Generation, FindsTheRatioOfTheLeastCost) {
  Random random{6};
  for (int trial = 0; trial < 200; ++trial) {
    PricingProblem pricing;
    pricing.constant = 2;
    pricing.bundles = 1 + static_cast<int>(random.below(4));
    pricing.capacity = 1 + static_cast<double>(random.below(10));
    for (int size = 0; size < 3; ++size) {
      pricing.gain.push_back(2 - static_cast<double>(random.below(6)));
      pricing.most.push_back(static_cast<int>(random.below(4)));
      pricing.weight.push_back(static_cast<double>(random.below(5)));
    }
    std::set<orders::Ratio> known;
    double least = lp::kInfinity;
    orders::for_each_ratio(3, pricing.bundles, [&](const orders::Ratio& ratio) {
      double cost = pricing.constant, weight = 0;
      bool allowed = true;
      for (std::size_t size = 0; size < 3; ++size) {
        cost += ratio[size] * pricing.gain[size];
        weight += ratio[size] * pricing.weight[size];
        allowed = allowed && ratio[size] <= pricing.most[size];
      }
      if (!allowed || weight > pricing.capacity) return;
      if (random.below(5) == 0) {
        known.insert(ratio);
      } else {
        least = std::min(least, cost);
      }
    });
    const PricedRatios priced = price_ratios(pricing, known);
    if (least == lp::kInfinity) {
      EXPECT_GT(priced.least, 1e200);
    } else {
      EXPECT_DOUBLE_EQ(priced.least, least) << trial;
    }
    EXPECT_EQ(priced.found.empty(), least >= 0) << trial;
  }
}

TEST(CuttingProgram, ReadsBackWhatItWrites) {
  const orders::Problem problem = larger_order();
  const Lengths lengths{{}, orders::LengthEstimate{problem.cloth.width}, false, {}};
  const SearchResult found = search(problem, lengths, small_search());
  ASSERT_TRUE(found.cutting);
  std::vector<Candidate> candidates = found.near;
  for (const Use& use : found.cutting->uses) candidates.push_back(use.candidate);
  const CuttingProgram program{problem, candidates};
  const auto x = program.solution_of(*found.cutting);
  ASSERT_TRUE(is_solution(program.program(), x));
  EXPECT_EQ(program.cutting_of(x), *found.cutting);
  EXPECT_NEAR(lp::integer::objective_of(program.program().linear, x), found.cutting->cost, 1e-6);
  EXPECT_TRUE(CuttingProgram(problem, found.near).solution_of(*found.cutting).empty());
}

// The largest order that the limits of each number allow has more garments than an int counts.
TEST(CuttingProgram, CountsTheGarmentsOfTheLargestOrder) {
  const orders::Problem problem = test::largest_order();
  const Candidate candidate{orders::single(orders::kMostSizes, 0), 1000};
  const CuttingProgram program{problem, {candidate}};
  const double garments = 1.0 * orders::kMostSizes * orders::kMostColours * orders::kMostGarments;
  EXPECT_EQ(program.program().linear.bound.back(), garments / orders::kMostPlies) << "the fewest lays";
}

}  // namespace
}  // namespace selvage::planning::cheapest
