// Orders, ratios and estimated lengths.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/planning/orders/length_estimate.h"
#include "core/planning/orders/order.h"
#include "core/planning/orders/ratio.h"

namespace selvage::planning::orders {
namespace {

Problem order_of(int garments) {
  Problem problem;
  problem.order = {{{"M", 1e6, 1e4}}, {"red"}, {{garments}}};
  problem.cloth.width = 1500;
  return problem;
}

TEST(Ratios, AreCountedAndListed) {
  EXPECT_EQ(number_of_ratios(5, 6, 1000), 461U);
  EXPECT_EQ(number_of_ratios(10, 10, 10'000), 10'000U);  // there are more
  for (const auto& [sizes, bundles] : {std::pair{1, 4}, {3, 3}, {4, 5}, {5, 6}}) {
    std::set<Ratio> seen;
    for_each_ratio(static_cast<std::size_t>(sizes), bundles, [&seen, most = bundles](const Ratio& ratio) {
      EXPECT_GE(bundles_in(ratio), 1);
      EXPECT_LE(bundles_in(ratio), most);
      EXPECT_TRUE(seen.empty() || *seen.rbegin() < ratio) << "not in lexical order";
      seen.insert(ratio);
    });
    EXPECT_EQ(seen.size(), number_of_ratios(static_cast<std::size_t>(sizes), bundles, 1'000'000));
  }
}

TEST(Ratios, HaveNeighboursOfOneBundle) {
  const auto neighbours = neighbours_of({1, 0, 2}, 3);
  EXPECT_EQ(std::set<Ratio>(neighbours.begin(), neighbours.end()),
            (std::set<Ratio>{{0, 0, 2}, {0, 1, 2}, {0, 0, 3}, {1, 0, 1}, {2, 0, 1}, {1, 1, 1}}));
  for (const Ratio& ratio : neighbours_of({1, 0}, 1)) EXPECT_EQ(bundles_in(ratio), 1);
}

TEST(Problem, RoundsItsLimitsTowardsTheOrder) {
  Problem problem = order_of(100);
  EXPECT_EQ(problem.least(0, 0), 100);
  EXPECT_EQ(problem.most(0, 0), 103);
  problem.limits.under = 0.015;
  EXPECT_EQ(problem.least(0, 0), 99);
  problem.order.garments[0][0] = 7;
  EXPECT_EQ(problem.most(0, 0), 7);
  problem.limits.under = 0;
  problem.cloth.spread = Spread::kFaceToFace;
  EXPECT_EQ(problem.most(0, 0), 8) << "plies come in pairs, and so do garments";
}

TEST(Problem, NamesItsFirstMistake) {
  EXPECT_FALSE(mistake_in(order_of(5)));
  EXPECT_EQ(mistake_in(order_of(0))->field, "/quantities");
  EXPECT_EQ(mistake_in(order_of(-1))->field, "/quantities/red/M");
  Problem problem = order_of(5);
  problem.limits.table = 0;
  EXPECT_EQ(mistake_in(problem)->field, "/limits/table");
  problem = order_of(5);
  problem.costs.metre = -1;
  EXPECT_EQ(mistake_in(problem)->field, "/costs/metre");
  EXPECT_NE(mistake_in(problem)->message.find("0 to 1000000000 is allowed"), std::string::npos)
      << mistake_in(problem)->message;
  problem = order_of(5);
  problem.order.garments[0].clear();
  EXPECT_TRUE(mistake_in(problem));
  EXPECT_TRUE(mistake_in(Problem{}));
}

TEST(Problem, LimitsTheNumberOfLays) {
  Problem problem = order_of(1'000'000);
  problem.limits.bundles = 1;
  problem.limits.plies = 10;
  EXPECT_FALSE(mistake_in(problem)) << "100,000 lays";
  problem.limits.plies = 9;
  const auto mistake = mistake_in(problem);
  ASSERT_TRUE(mistake);
  EXPECT_EQ(mistake->code, ErrorCode::kOutOfRange);
  EXPECT_EQ(mistake->field, "/limits/plies");
  EXPECT_NE(mistake->message.find("111112 lays"), std::string::npos) << mistake->message;
  EXPECT_NE(mistake->message.find("at most 100000"), std::string::npos) << mistake->message;
  problem.limits.bundles = 2;
  EXPECT_FALSE(mistake_in(problem));
  problem.limits.bundles = 1;
  problem.limits.plies = 11;
  problem.cloth.spread = Spread::kFaceToFace;
  EXPECT_FALSE(mistake_in(problem)) << "five pairs of plies in a lay";
}

TEST(Problem, NamesMistakesInRollsAndRemnants) {
  Problem problem = order_of(5);
  problem.cloth.roll_length = 11'999;
  EXPECT_EQ(mistake_in(problem)->field, "/cloth/rollLength") << "shorter than the table";
  problem.cloth.roll_length = 12'000;
  EXPECT_FALSE(mistake_in(problem));
  problem.cloth.splice_loss = 6'001;
  EXPECT_EQ(mistake_in(problem)->field, "/cloth/rollLength") << "shorter than two splices";
  problem = order_of(5);
  problem.cloth.remnants = {{0, 100}, {1, 100}};
  EXPECT_EQ(mistake_in(problem)->field, "/cloth/remnants/1/colour");
  problem.cloth.remnants[1] = {0, -1};
  EXPECT_EQ(mistake_in(problem)->field, "/cloth/remnants/1/length");
  problem.cloth.remnants.assign(101, {0, 100});
  EXPECT_EQ(mistake_in(problem)->field, "/cloth/remnants");
}

TEST(Problem, SpreadsSplicesOverTheCloth) {
  Problem problem = order_of(5);
  EXPECT_DOUBLE_EQ(problem.roll_rate(), 0.005);
  problem.cloth.roll_length = 50'500;
  EXPECT_DOUBLE_EQ(problem.roll_rate(), 0.005 * 1.01) << "500 mm in 50,000";
  EXPECT_DOUBLE_EQ(problem.remnant_saving(), problem.roll_rate());
  problem.costs.remnant_metre = 6;
  EXPECT_DOUBLE_EQ(problem.remnant_saving(), 0) << "dearer than rolls";
}

TEST(LengthEstimate, LearnsFromStoredMarkersUntilSomeAreMade) {
  const double width = 1500;
  const auto stored_length = [&](double area) { return 1.3 * area / width + 60; };
  const auto made_length = [&](double area) { return 1.2 * area / width + 60; };
  std::vector<MadeLength> stored, made;
  for (const double area : {1e6, 2e6, 4e6, 6e6}) {
    stored.push_back({area, stored_length(area)});
    made.push_back({area, made_length(area)});
  }
  const LengthEstimate guess{width}, learnt{width, {}, stored}, corrected{width, made, stored};
  for (const double area : {1.5e6, 5e6}) {
    const double length = stored_length(area), real = made_length(area);
    EXPECT_LT(std::abs(learnt.length_of(area) - length), 0.3 * std::abs(guess.length_of(area) - length));
    EXPECT_LT(std::abs(corrected.length_of(area) - real), 0.2 * std::abs(learnt.length_of(area) - real));
  }
}

TEST(LengthEstimate, LearnsFromMadeMarkers) {
  const double width = 1500;
  const LengthEstimate guess{width};
  std::vector<MadeLength> made;
  for (const double area : {1e6, 2e6, 4e6, 6e6}) made.push_back({area, 1.2 * area / width + 90});
  const LengthEstimate fitted{width, made};
  for (const double area : {1.5e6, 5e6}) {
    const double real = 1.2 * area / width + 90;
    EXPECT_LT(std::abs(fitted.length_of(area) - real), 0.005 * real);
    EXPECT_LT(std::abs(fitted.length_of(area) - real), std::abs(guess.length_of(area) - real));
    EXPECT_NEAR(fitted.length_of(area), fitted.length_per_area() * area + fitted.length_of_ends(), 1e-9);
  }
}

TEST(LengthEstimate, KnowsHowUncertainItIs) {
  const double width = 1500;
  std::vector<MadeLength> made;
  double deviation = LengthEstimate{width}.deviation_at(6'000);
  EXPECT_NEAR(deviation, std::hypot(0.06 * (6'000 - 0.05 * width) / 1.14, 0.08 * width, 0.01 * 6'000), 1e-6);
  for (const double area : {2e6, 3e6, 6e6, 7e6}) {
    made.push_back({area, 1.2 * area / width + 90});
    const LengthEstimate fitted{width, made};
    EXPECT_LT(fitted.deviation_at(6'000), deviation);
    deviation = fitted.deviation_at(6'000);
    EXPECT_GT(fitted.deviation_at(12'000), deviation) << "the made markers say less about longer ones";
  }
  EXPECT_GT(deviation, 60) << "markers of the same area differ by 1 %";
  EXPECT_LT(deviation, 90);
}

TEST(LengthEstimate, NeverPromisesMoreThanTheAreaOfThePieces) {
  const std::vector<MadeLength> made(20, MadeLength{3e6, 1000});  // shorter than the pieces' area allows
  EXPECT_GE(LengthEstimate(1500, made).length_of(3e6), 2000);
}

}  // namespace
}  // namespace selvage::planning::orders
