// Sets of few markers, against all cuttings of small orders.
#include "core/planning/program/few_markers.h"

#include <gtest/gtest.h>

#include "core/planning/program/plies.h"
#include "core/planning/program/relaxation.h"
#include "tests/core/planning/small_orders.h"

namespace selvage::planning::program {
namespace {

using test::EveryCutting;
using test::Random;

constexpr std::uint64_t kPlenty = 1'000'000'000;

TEST(FewMarkers, AreAllCuttingsWhenThereIsTime) {
  Random random{11};
  int feasible = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const orders::Problem problem = test::small_order(random);
    const auto candidates = test::all_candidates(problem);
    const double least = EveryCutting{problem}.least_cost();
    const FewMarkers few = few_markers(problem, candidates, {kPlenty});
    EXPECT_GT(few.fewest, 1);
    ASSERT_EQ(few.cutting.has_value(), least < lp::kInfinity) << trial;
    if (!few.cutting) continue;
    ++feasible;
    EXPECT_LE(few.least, few.cutting->cost * (1 + 1e-9));
    EXPECT_LE(few.least, least * (1 + 1e-9)) << "lays may be more than one";
    EXPECT_GE(few.cutting->cost, least * (1 - 1e-9));
    EXPECT_TRUE(delivers(problem, few.cutting->uses));
  }
  EXPECT_GT(feasible, 20);
}

// If one lay has room for all plies, the bounds of the sets are exact.
TEST(FewMarkers, AreExactWhereOneLayIsEnough) {
  Random random{12};
  for (int trial = 0; trial < 40; ++trial) {
    orders::Problem problem = test::small_order(random);
    problem.limits.plies = 100;
    const double least = EveryCutting{problem}.least_cost();
    const FewMarkers few = few_markers(problem, test::all_candidates(problem), {kPlenty});
    if (least == lp::kInfinity) {
      EXPECT_EQ(few.least, lp::kInfinity) << trial;
      continue;
    }
    EXPECT_NEAR(few.least, least, 1e-9 * least) << trial;
    ASSERT_TRUE(few.cutting);
    EXPECT_NEAR(few.cutting->cost, least, 1e-9 * least) << trial;
  }
}

// Five sizes, and a colour that needs as many markers as there are sizes: single bundles, and no more than they
// deliver.
TEST(FewMarkers, KnowHowManyAnOrderNeeds) {
  orders::Problem problem;
  problem.cloth.width = 1500;
  problem.limits.bundles = 1;
  problem.limits.over = 0;
  problem.order.colours = {"red"};
  problem.order.garments = {{7, 7, 7, 7, 7}};
  for (int size = 0; size < 5; ++size) problem.order.sizes.push_back({std::to_string(size), 1e6, 9'000});
  const auto candidates = test::all_candidates(problem);
  EXPECT_EQ(few_markers(problem, candidates, {30}).fewest, 3) << "the sets of three are too many";
  const FewMarkers all = few_markers(problem, candidates, {kPlenty});
  ASSERT_TRUE(all.cutting);
  EXPECT_EQ(all.cutting->uses.size(), 5U);
  problem.limits.bundles = 5;
  const FewMarkers together = few_markers(problem, test::all_candidates(problem), {kPlenty / 1000});
  ASSERT_TRUE(together.cutting);
  EXPECT_EQ(together.cutting->uses.size(), 1U) << "one marker with a bundle of each size";
}

TEST(FewMarkers, RaiseTheBound) {
  Random random{13};
  for (int trial = 0; trial < 40; ++trial) {
    const orders::Problem problem = test::small_order(random);
    const auto candidates = test::all_candidates(problem);
    const double least = EveryCutting{problem}.least_cost();
    const auto relaxed = bound_with(problem, candidates, 1);
    ASSERT_TRUE(relaxed);
    EXPECT_LE(*relaxed, least * (1 + 1e-7)) << trial;
    const FewMarkers few = few_markers(problem, candidates, {50});
    const auto others = bound_with(problem, candidates, few.fewest);
    ASSERT_TRUE(others);
    EXPECT_GE(*others, *relaxed * (1 - 1e-7)) << trial;
    EXPECT_LE(std::min(few.least, *others), least * (1 + 1e-7)) << trial;
  }
}

TEST(FewMarkers, AreNotListedBeyondTheTarget) {
  Random random{15};
  int fewer = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const orders::Problem problem = test::small_order(random);
    const auto candidates = test::all_candidates(problem);
    const FewMarkers all = few_markers(problem, candidates, {kPlenty});
    if (!all.cutting) continue;
    const FewMarkers some = few_markers(problem, candidates, {kPlenty, all.least * 2});
    EXPECT_LE(some.fewest, all.fewest);
    EXPECT_GE(some.least, all.least);
    if (some.fewest < all.fewest) ++fewer;
  }
  EXPECT_GT(fewer, 5);
}

TEST(FewMarkers, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  Random random{14};
  orders::Problem problem = test::small_order(random);
  problem.order.colours = {"red"};
  problem.order.sizes.clear();
  problem.order.garments = {{}};
  for (int size = 0; size < 6; ++size) {
    problem.order.sizes.push_back({std::to_string(size), 1e6, 9'000});
    problem.order.garments[0].push_back(20 + 7 * size);
  }
  problem.limits.bundles = 6;
  EXPECT_LE(few_markers(problem, test::all_candidates(problem), {kPlenty}, stop.get_token()).fewest, 3);
}

TEST(Plies, AreTheCheapestThatDeliver) {
  const orders::Ratio large{2, 1}, single{1, 0}, other{0, 1};
  const std::vector<Member> members{{&large, 5}, {&single, 2.6}, {&other, 2}};
  std::uint64_t work = kPlenty;
  const auto found = cheapest_plies({{4, 3}, {5, 3}}, members, work);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->units, (std::vector<int>{2, 0, 1}));
  EXPECT_DOUBLE_EQ(found->cost, 12);
  EXPECT_LT(work, kPlenty);
  EXPECT_FALSE(cheapest_plies({{4, 3}, {5, 3}}, std::span{members}.first(1), work)) << "two and one, or four and two";
  work = 2;
  EXPECT_FALSE(cheapest_plies({{4, 3}, {5, 3}}, members, work));
  EXPECT_EQ(work, 0U);
}

}  // namespace
}  // namespace selvage::planning::program
