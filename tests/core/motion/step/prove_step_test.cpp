#include "core/motion/step/prove_step.h"

#include <gtest/gtest.h>

#include "tests/core/motion/markers.h"

namespace selvage::motion::step {
namespace {

using test::Layout;

constexpr std::array kFractions{1.0, 0.5};

// Two squares side by side, 100 units apart.
marker::PlacedPieces two_squares() {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(1000, 1000));
  layout.put(square, {0, 0}).put(square, {1100, 0});
  return marker::PlacedPieces{layout.marker()};
}

TEST(ProveStep, TakesTheWholeStepWhenNothingCollides) {
  const auto proved = prove_step(two_squares(), {{0, 0}, {-100, 3}}, {}, kFractions, serial());
  ASSERT_TRUE(proved.moved);
  EXPECT_EQ(proved.moved->at(1), (Vec{1000, 3}));
  EXPECT_TRUE(proved.conflicts.empty());
}

TEST(ProveStep, ShortensAStepThatIsInvalidByRounding) {
  const PairSet modelled{{0, 1}};
  const auto proved = prove_step(two_squares(), {{0, 0}, {-120, 0}}, modelled, kFractions, serial());
  ASSERT_TRUE(proved.moved);
  EXPECT_EQ(proved.moved->at(1), (Vec{1040, 0}));
  EXPECT_EQ(proved.displacements[1].x, -60);
}

TEST(ProveStep, ReportsCollisionsOfPairsThatWereNotModelled) {
  const auto proved = prove_step(two_squares(), {{0, 0}, {-120, 0}}, {}, kFractions, serial());
  EXPECT_FALSE(proved.moved);
  EXPECT_EQ(proved.conflicts, (std::vector<marker::PiecePair>{{0, 1}}));
}

TEST(ProveStep, ReportsTheCollisionsOfTheWholeStepWhenNoFractionIsValid) {
  const PairSet modelled{{0, 1}};
  const auto proved = prove_step(two_squares(), {{0, 0}, {-300, 0}}, modelled, kFractions, serial());
  EXPECT_FALSE(proved.moved);
  EXPECT_EQ(proved.conflicts, (std::vector<marker::PiecePair>{{0, 1}}));
}

TEST(ProveStep, HalvesAStepUntilItIsValid) {
  const std::vector<RealVec> step{{0, 0}, {-300, 0}};
  EXPECT_FALSE(halve_until_valid(two_squares(), step, 1, serial()).moved);
  const auto proved = halve_until_valid(two_squares(), step, 3, serial());
  ASSERT_TRUE(proved.moved);
  EXPECT_EQ(proved.moved->at(1), (Vec{1025, 0}));
  EXPECT_EQ(proved.displacements[1].x, -75);
}

}  // namespace
}  // namespace selvage::motion::step
