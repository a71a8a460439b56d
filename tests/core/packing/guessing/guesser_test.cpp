#include "core/packing/guessing/guesser.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "core/marker/validity.h"
#include "core/packing/bodies/bodies.h"
#include "core/packing/bodies/place_leaf.h"
#include "core/packing/guessing/guessed_layouts.h"
#include "tests/core/motion/markers.h"

namespace selvage::packing::guessing {
namespace {

// Twelve rectangles of three shapes, four of each, and a box of which they fill 78 %.
class TwelveRectangles : public testing::Test {
 protected:
  TwelveRectangles() {
    for (const Coord height : {6'000, 9'000, 12'000}) {
      const auto shape = layout_.shape_of(test::rectangle(8'000, height));
      for (int k = 0; k < 4; ++k) layout_.put(shape, {0, 0});
    }
    marker_ = layout_.marker();
    bodies_ = bodies::bodies_of(marker_, freedom_, run_);
  }

  [[nodiscard]] GuessedLayouts guessed(const std::stop_token& stop = {}) const {
    const auto place = [this](branching::Leaf& leaf) {
      return bodies::place_leaf(marker_, bodies_, freedom_, run_, leaf);
    };
    return {bodies_.problem, branching::SearchTuning{}, place, stop};
  }

  test::Layout layout_{30'000};
  Marker marker_;
  SumCache sums_;
  scene::Run run_{sums_};
  bodies::Freedom freedom_{std::vector<bool>(12, true), Box{{0, 0}, {37'000, 30'000}}, false};
  bodies::Bodies bodies_;
};

TEST_F(TwelveRectangles, SameProblemGivesSameGuesses) {
  Guesser one{bodies_.problem};
  Guesser other{bodies_.problem};
  for (int k = 0; k < 3; ++k) {
    std::int64_t moves = 40;
    std::int64_t again = 40;
    const Guess first = one.next(moves, {});
    const Guess second = other.next(again, {});
    EXPECT_EQ(first.variant, second.variant);
    EXPECT_EQ(moves, again);
    EXPECT_LE(moves, 0);
    ASSERT_EQ(first.positions.size(), second.positions.size());
    for (std::size_t body = 0; body < first.positions.size(); ++body) {
      EXPECT_EQ(first.positions[body].x, second.positions[body].x);
      EXPECT_EQ(first.positions[body].y, second.positions[body].y);
    }
  }
}

TEST_F(TwelveRectangles, BodiesOfOneKindAreInOrderAndInTheRoom) {
  EXPECT_TRUE(bodies_.problem.is_ordered_by_y(0, 0));  // of height 6000
  EXPECT_FALSE(bodies_.problem.is_ordered_by_y(11, 0));
  std::int64_t moves = 24;
  const Guess guess = Guesser{bodies_.problem}.next(moves, {});
  for (std::size_t body = 0; body < guess.positions.size(); ++body) {
    const auto& range = bodies_.problem.bodies[body].variants[guess.variant[body]].range;
    EXPECT_GE(guess.positions[body].x, range.low_x);
    EXPECT_LE(guess.positions[body].x, range.high_x);
    EXPECT_GE(guess.positions[body].y, range.low_y);
    EXPECT_LE(guess.positions[body].y, range.high_y);
    if (body % 4 > 0 && bodies_.problem.is_ordered_by_y(static_cast<std::uint32_t>(body), 0)) {
      EXPECT_GE(guess.positions[body].y, guess.positions[body - 1].y);
    } else if (body % 4 > 0) {
      EXPECT_GE(guess.positions[body].x, guess.positions[body - 1].x);
    }
  }
}

TEST_F(TwelveRectangles, LayoutNearAGuessIsValid) {
  branching::Work work{.nodes = 1'000};
  const auto layout = guessed().next(work);
  ASSERT_TRUE(layout);
  EXPECT_TRUE(is_valid(bodies::placed(marker_, bodies_, *layout)));
  EXPECT_GE(work.nodes, 1'000U);
}

// Some of the positions are a little beside those of the layout.
TEST_F(TwelveRectangles, GuessesThatBeginNearALayoutFindOne) {
  branching::Work work{.nodes = 1'000};
  const auto layout = guessed().next(work);
  ASSERT_TRUE(layout);
  std::vector<RealVec> positions = layout->positions;
  for (std::size_t body = 0; body < positions.size(); body += 3) positions[body].x += 100;
  GuessedLayouts again = guessed();
  ASSERT_TRUE(again.begin_at(positions));
  branching::Work brief;
  const auto found = again.next(brief);
  ASSERT_TRUE(found);
  EXPECT_TRUE(is_valid(bodies::placed(marker_, bodies_, *found)));
  EXPECT_LT(brief.nodes, 100U);
  EXPECT_FALSE(again.next(brief));
}

// An L in a room of the size of its box leaves one corner free for a square: which one depends on how it is turned.
TEST(GuesserBeginAt, TakesTheVariantsThatOverlapLeast) {
  test::Layout layout{10'000};
  const Polygon angle{{0, 0}, {10'000, 0}, {10'000, 4'900}, {4'900, 4'900}, {4'900, 10'000}, {0, 10'000}};
  layout.put(layout.shape_of(angle), {0, 0}).put(layout.shape_of(test::rectangle(5'000, 5'000)), {0, 0});
  Marker marker = layout.marker();
  marker.shapes[0].rotations = {Angle{}, Angle::of_degrees(90), Angle::of_degrees(180), Angle::of_degrees(270)};
  SumCache sums;
  const bodies::Freedom freedom{std::vector<bool>(2, true), Box{{0, 0}, {10'000, 10'000}}, true};
  const bodies::Bodies bodies = bodies::bodies_of(marker, freedom, scene::Run{sums});
  for (const RealVec corner : {RealVec{0, 0}, RealVec{5'000, 0}, RealVec{0, 5'000}, RealVec{5'000, 5'000}}) {
    Guesser guesser{bodies.problem};
    guesser.begin_at({{0, 0}, corner});
    std::int64_t moves = 1;
    const Guess guess = guesser.next(moves, {});
    EXPECT_EQ(guess.positions[1].x, corner.x);
    EXPECT_EQ(guess.positions[1].y, corner.y);
  }
}

TEST_F(TwelveRectangles, NoGuessIsMadeBeforeTheSearchHasTakenLongNorAfterAStop) {
  branching::Work brief{.nodes = 50};
  EXPECT_FALSE(guessed().next(brief));
  EXPECT_EQ(brief.nodes, 50U);
  std::stop_source stop;
  stop.request_stop();
  branching::Work work{.nodes = 1'000};
  EXPECT_FALSE(guessed(stop.get_token()).next(work));
}

}  // namespace
}  // namespace selvage::packing::guessing
