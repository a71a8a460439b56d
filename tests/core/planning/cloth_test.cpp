// The cloth under a plan: what lies on remnants, and the rolls and splices of the rest.
#include <gtest/gtest.h>

#include <numeric>

#include "core/planning/lays.h"
#include "core/planning/plan.h"
#include "core/planning/program/remnants.h"
#include "tests/core/planning/small_orders.h"

namespace selvage::planning {
namespace {

using orders::Problem;
using program::Cutting;
using test::Random;

// A cutting of some of the candidates, whatever is ordered.
Cutting random_cutting(const Problem& problem, Random& random, std::size_t most_units) {
  Cutting cutting;
  for (const auto& candidate : test::all_candidates(problem)) {
    if (random.below(2) == 0) continue;
    program::Use use{candidate, {}};
    for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour)
      use.units.push_back(static_cast<int>(random.below(most_units + 1)));
    use.units[0] += 1;
    cutting.uses.push_back(std::move(use));
    if (cutting.uses.size() == 3) break;
  }
  cutting.cost = cost_of(problem, cutting.uses);
  return cutting;
}

TEST(Remnants, CoverAsMuchAsTheyCan) {
  Random random{11};
  for (int trial = 0; trial < 200; ++trial) {
    const Problem problem = test::small_order_with_remnants(random);
    const Cutting cutting = random_cutting(problem, random, 2);
    const auto filled = spread_on_remnants(problem, cutting.uses);
    EXPECT_NEAR(filled.length, test::EverySpreading(problem, cutting.uses).most(), 1e-6) << trial;
    double covered = 0;
    for (std::size_t r = 0; r < problem.cloth.remnants.size(); ++r) {
      double length = 0;
      for (std::size_t k = 0; k < cutting.uses.size(); ++k)
        length += filled.units[k][r] * problem.unit_length(cutting.uses[k].candidate.length);
      EXPECT_LE(length, problem.cloth.remnants[r].length + 1e-5);
      covered += length;
    }
    EXPECT_NEAR(covered, filled.length, 1e-6);
    for (std::size_t k = 0; k < cutting.uses.size(); ++k) {
      std::vector<int> units(problem.order.colours.size());
      for (std::size_t r = 0; r < problem.cloth.remnants.size(); ++r)
        units[problem.cloth.remnants[r].colour] += filled.units[k][r];
      for (std::size_t colour = 0; colour < units.size(); ++colour)
        EXPECT_LE(units[colour], cutting.uses[k].units[colour]);
    }
  }
}

TEST(Remnants, StayWhereTheyAreWhenTheySaveNothing) {
  Random random{12};
  Problem problem = test::small_order_with_remnants(random);
  problem.costs.remnant_metre = 2 * problem.costs.metre;
  const Cutting cutting = random_cutting(problem, random, 2);
  EXPECT_EQ(spread_on_remnants(problem, cutting.uses).length, 0);
}

TEST(Lays, TellWhichPliesComeFromRemnants) {
  Random random{13};
  for (int trial = 0; trial < 50; ++trial) {
    const Problem problem = test::small_order_with_remnants(random);
    const Cutting cutting = random_cutting(problem, random, 8);
    const auto filled = spread_on_remnants(problem, cutting.uses);
    std::vector<int> expected(problem.cloth.remnants.size()), told(expected.size());
    for (const auto& units : filled.units) {
      for (std::size_t r = 0; r < expected.size(); ++r) expected[r] += problem.plies_of_unit() * units[r];
    }
    for (const Lay& lay : lays_of(problem, cutting)) {
      EXPECT_LE(std::accumulate(lay.plies.begin(), lay.plies.end(), 0), problem.limits.plies);
      std::vector<int> of_colour(lay.plies.size());
      for (std::size_t r = 0; r < told.size(); ++r) {
        told[r] += lay.on_remnants[r];
        of_colour[problem.cloth.remnants[r].colour] += lay.on_remnants[r];
      }
      for (std::size_t colour = 0; colour < of_colour.size(); ++colour) EXPECT_LE(of_colour[colour], lay.plies[colour]);
    }
    EXPECT_EQ(told, expected);
  }
}

// One marker of 4,960 mm under this many plies of one colour: each takes 5,000 mm.
Cutting five_metres(int plies) {
  Cutting cutting;
  program::Use& use = cutting.uses.emplace_back();
  use.candidate.ratio.push_back(1);
  use.candidate.length = 4'960;
  use.units.push_back(plies);
  return cutting;
}
Problem one_colour() {
  Problem problem;
  problem.order = {{{"M", 1e6, 1e4}}, {"red"}, {{10}}};
  problem.cloth.width = 1500;
  problem.cloth.roll_length = 12'000;
  return problem;
}

TEST(Rolls, AreSplicedWhereTheyEndWithinAPly) {
  Problem problem = one_colour();
  const auto rolls = [&](int plies) {
    const Cutting cutting = five_metres(plies);
    return rolls_of(problem, cutting, lays_of(problem, cutting))[0];
  };
  EXPECT_EQ(rolls(2), (Rolls{.cloth = 10'000, .rolls = 1, .splices = 0, .lost = 0, .left = 2'000}));
  // The third ply takes the 2,000 that are left, and 3,500 of the next roll.
  EXPECT_EQ(rolls(3), (Rolls{.cloth = 15'000, .rolls = 2, .splices = 1, .lost = 500, .left = 8'500}));
  problem.cloth.roll_length = 15'300;  // 300 are left after three plies: less than a splice
  EXPECT_EQ(rolls(4), (Rolls{.cloth = 20'000, .rolls = 2, .splices = 0, .lost = 300, .left = 10'300}));
  problem.cloth.roll_length = 0;
  EXPECT_EQ(rolls(4), (Rolls{.cloth = 20'000, .rolls = 0, .splices = 0, .lost = 0, .left = 0}));
}

TEST(Rolls, AddUp) {
  Random random{14};
  for (int trial = 0; trial < 100; ++trial) {
    Problem problem = test::small_order_with_remnants(random);
    problem.cloth.roll_length = 12'000 + static_cast<double>(random.below(20'000));
    const Cutting cutting = random_cutting(problem, random, 30);
    const auto rolls = rolls_of(problem, cutting, lays_of(problem, cutting));
    double cloth = spread_on_remnants(problem, cutting.uses).length;
    for (const Rolls& one : rolls) {
      EXPECT_NEAR(one.rolls * problem.cloth.roll_length, one.cloth + one.lost + one.left, 1e-3);
      EXPECT_LE(one.lost, one.rolls * problem.cloth.splice_loss);
      EXPECT_LT(one.splices, one.rolls + 1);
      cloth += one.cloth;
    }
    EXPECT_NEAR(cloth, cloth_of(problem, cutting.uses), 1e-3);
  }
}

TEST(Plan, ReplacesRollsByRemnants) {
  Random random{15};
  for (int trial = 0; trial < 10; ++trial) {
    Problem problem = test::small_order_with_remnants(random);
    const auto lengths = [&](const orders::Ratio& ratio) {
      return std::optional{test::length_of_ratio(problem, ratio)};
    };
    PlanSettings settings;
    settings.search.tuning.annealing_steps = 200;
    settings.search.tuning.set_work = 10'000;
    const auto with = plan_cut(problem, settings, lengths, {});
    problem.cloth.remnants.clear();
    const auto without = plan_cut(problem, settings, lengths, {});
    ASSERT_EQ(static_cast<bool>(with), static_cast<bool>(without));
    if (!with) continue;
    EXPECT_TRUE(delivers(problem, with->cutting.uses));
    EXPECT_LE(with->cutting.cost, without->cutting.cost * (1 + settings.search.gap));
    EXPECT_LE(with->bound, with->cutting.cost);
  }
}

}  // namespace
}  // namespace selvage::planning
