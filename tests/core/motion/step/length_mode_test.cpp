// What programs say about the marker's length, and about flights.
#include "core/motion/step/length_mode.h"

#include <gtest/gtest.h>

#include "tests/core/motion/markers.h"

namespace selvage::motion::step {
namespace {

// Two squares side by side, the second of which moves.
class Flights : public ::testing::Test {
 protected:
  Flights() {
    const auto square = layout_.shape_of(test::rectangle(100, 100));
    layout_.put(square, {0, 0}).put(square, {120, 0});
  }
  [[nodiscard]] std::vector<model::PairRow> limits(RealVec by, double limit, bool shortens = true) const {
    SumCache sums;
    const scene::Scene scene{layout_.marker(), sums};
    Goal goal = leftward_goal(scene, 0.003);
    if (!shortens) goal.shorten = 0;
    const StepSettings settings{.trust = 0.1};
    NearPairs near{scene, goal, settings};
    model::ActiveSet active{scene.ties, 1};
    active.add_all();
    near.extend(active, {}, {sums});
    return length_mode(scene, goal, settings, near)->limits_of_flights({{{0, 0}, by}, 0}, limit);
  }

  test::Layout layout_{1000};
};

TEST_F(Flights, ALimitStopsEachAxisThatExceedsIt) {
  const auto rows = limits({-900, 700}, 600);
  ASSERT_EQ(rows.size(), 2U);
  for (const model::PairRow& row : rows) {
    EXPECT_EQ(row.pair, (marker::PiecePair{0, 1}));
    EXPECT_EQ(row.bound, -600);
  }
  // The rows allow the second piece to move by the limit, and no farther.
  EXPECT_EQ(along(rows[0], {-600, 0}), rows[0].bound);
  EXPECT_LT(along(rows[0], {-900, 700}), rows[0].bound);
  EXPECT_EQ(along(rows[1], {0, 600}), rows[1].bound);
  EXPECT_LT(along(rows[1], {-900, 700}), rows[1].bound);
}

TEST_F(Flights, ShorterMovesAreNotLimited) {
  EXPECT_TRUE(limits({-590, 590}, 600).empty());
  EXPECT_EQ(limits({-610, 590}, 600).size(), 1U);
}

TEST_F(Flights, AtFixedLengthOtherRowsLimitThem) {
  EXPECT_TRUE(limits({-900, 700}, 600, false).empty());
}

}  // namespace
}  // namespace selvage::motion::step
