#include "core/packing/programs/dictionary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/packing/programs/leaf_proof.h"

namespace selvage::packing::programs {
namespace {

constexpr double kNoCeiling = std::numeric_limits<double>::infinity();

// Two bodies of width 10 on a strip; the length is at least both ends.
struct Pair {
  Columns columns{.bodies = 2, .low = {{0, 0}, {0, 0}}, .low_length = 0, .scale = 1.0 / 64};
  Dictionary program{columns, true};
  Ranges ranges{{{0, 0, 100, 20}, {0, 0, 100, 20}}, 0, 1000};
  std::uint64_t pivots{};

  Pair() {
    add({0, 0, true, {1, 0, 10}});
    add({1, 1, true, {1, 0, 10}});
  }
  void add(const Row& row) { program.add(columns, row); }
  Dictionary::End solve(double ceiling = kNoCeiling) { return program.solve(columns, ceiling, pivots); }
};

TEST(Dictionary, MinimisesTheLength) {
  Pair pair;
  pair.add({0, 1, false, {1, 0, 10}});
  ASSERT_EQ(pair.solve(), Dictionary::End::kOptimal);
  EXPECT_NEAR(pair.program.length(pair.columns), 20, 1e-6);
  EXPECT_NEAR(pair.program.position(pair.columns, 1).x, 10, 1e-6);
  EXPECT_NEAR(least_length(pair.program.bounding(), pair.ranges), 20, 1e-4);
  EXPECT_LE(least_length(pair.program.bounding(), pair.ranges), 20);
}

TEST(Dictionary, ContinuesFromItsBasisWhenRowsAreAdded) {
  Pair pair;
  ASSERT_EQ(pair.solve(), Dictionary::End::kOptimal);
  EXPECT_NEAR(pair.program.length(pair.columns), 10, 1e-6);
  const double half = std::sqrt(0.5);
  pair.add({0, 1, false, {half, half, 30 * half}});
  pair.add({1, 2, false, {0, 1, -12}});  // the second body's y is at most 12
  ASSERT_EQ(pair.solve(), Dictionary::End::kOptimal);
  EXPECT_NEAR(pair.program.length(pair.columns), 28, 1e-6);
}

TEST(Dictionary, ProvesInfeasibility) {
  Pair pair;
  pair.add({0, 1, false, {1, 0, 10}});
  pair.add({1, 0, false, {1, 0, -9}});
  ASSERT_EQ(pair.solve(), Dictionary::End::kInfeasible);
  EXPECT_TRUE(refutes(pair.program.refuting(), pair.ranges));
}

TEST(Dictionary, StopsAboveTheCeiling) {
  Pair pair;
  pair.add({0, 1, false, {1, 0, 10}});
  ASSERT_EQ(pair.solve(19), Dictionary::End::kAboveCeiling);
  EXPECT_GT(least_length(pair.program.bounding(), pair.ranges), 19);
}

TEST(LeafProof, NeverClaimsMoreThanTheRowsSay) {
  Pair pair;
  const Row row{0, 1, false, {1, 0, 10}};
  // A multiple of one row alone bounds nothing: both bodies can move.
  EXPECT_FALSE(refutes(std::vector<Dictionary::Multiplier>{{row, 1}}, pair.ranges));
  const Row back{1, 0, false, {1, 0, -10}};
  EXPECT_FALSE(refutes(std::vector<Dictionary::Multiplier>{{row, 1}, {back, 1}}, pair.ranges));
  const Row beyond{1, 0, false, {1, 0, -9.999}};
  EXPECT_TRUE(refutes(std::vector<Dictionary::Multiplier>{{row, 1}, {beyond, 1}}, pair.ranges));
  EXPECT_EQ(least_length({}, pair.ranges), 0);
}

TEST(LeafProof, NamesRowsAndAsFewRangesAsItNeeds) {
  Pair pair;
  const std::vector<RealBox> wide{{0, 0, 100, 20}, {0, 0, 100, 20}};
  pair.ranges.wide = wide;
  pair.ranges.bodies = {{70, 0, 100, 20}, {0, 0, 60, 20}};
  pair.ranges.why = {{.low_x = decision(1)}, {.high_x = decision(2)}};
  // The second body is right of the first.  Both ranges are needed; neither of them suffices alone.
  const std::vector<Dictionary::Multiplier> near{{{0, 1, false, {1, 0, 10}, decision(0)}, 1}};
  ASSERT_TRUE(refutes(near, pair.ranges));
  EXPECT_EQ(why_refuted(near, pair.ranges), decision(0) | decision(1) | decision(2));
  // So far to the right that one range suffices.
  const std::vector<Dictionary::Multiplier> far{{{0, 1, false, {1, 0, 65}, decision(0)}, 1}};
  ASSERT_TRUE(refutes(far, pair.ranges));
  EXPECT_EQ(why_refuted(far, pair.ranges), decision(0) | decision(1));
  // The marker ends behind the first body, whatever the range of the second.
  const std::vector<Dictionary::Multiplier> end{{{0, 0, true, {1, 0, 10}}, 1}};
  EXPECT_EQ(why_longer(end, pair.ranges, 70), decision(1));
}

TEST(Dictionary, DropsRowsWithRoomAndKeepsItsSolution) {
  Pair pair;
  pair.add({0, 1, false, {1, 0, 10}});
  pair.add({0, 1, false, {0, 1, -15}});
  ASSERT_EQ(pair.solve(), Dictionary::End::kOptimal);
  const RealVec before = pair.program.position(pair.columns, 1);
  pair.program.drop_slack_rows(pair.columns, 5);
  ASSERT_EQ(pair.solve(), Dictionary::End::kOptimal);
  EXPECT_EQ(pair.program.position(pair.columns, 1).x, before.x);
  EXPECT_NEAR(pair.program.length(pair.columns), 20, 1e-6);
}

}  // namespace
}  // namespace selvage::packing::programs
