#include "core/motion/piece/bump.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <thread>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/support/polygons.h"

namespace selvage::motion::piece {
namespace {

using test::Layout;

Bump bumped(const Marker& marker, std::uint32_t piece, double dx, double dy) {
  SumCache sums;
  scene::Scene scene{marker, sums};
  const Bump result = bump(scene, PieceId{piece}, dx, dy);
  Marker moved = marker;
  moved.pieces[piece].at = result.at;
  EXPECT_TRUE(is_valid(moved));
  EXPECT_GE(result.gain, 0);
  return result;
}

TEST(Bump, MovesStraightToTheEdge) {
  Layout layout{1000};
  layout.put(layout.shape_of(test::rectangle(300, 200)), {5000, 400});
  EXPECT_EQ(bumped(layout.marker(), 0, -1, 0).at, (Vec{0, 400}));
  EXPECT_EQ(bumped(layout.marker(), 0, 0, 5).at, (Vec{5000, 800}));
  EXPECT_EQ(bumped(layout.marker(), 0, 1, 0).at, (Vec{5000, 400}));  // it is the marker's end
  EXPECT_EQ(bumped(layout.marker(), 0, 0, 0).at, (Vec{5000, 400}));
  EXPECT_EQ(bumped(layout.marker(), 0, -1, -1).at, (Vec{0, 0}));
}

TEST(Bump, SlidesAlongPiecesThatItMeets) {  // down a ramp and on along the floor
  Layout layout{1000};
  const auto ramp = layout.shape_of({{0, 0}, {600, 0}, {0, 600}});
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(ramp, {0, 0}).put(square, {300, 800}).put(square, {1900, 0});
  const Bump down = bumped(layout.marker(), 1, 0, -1);
  EXPECT_EQ(down.at, (Vec{600, 0}));
  EXPECT_TRUE(down.touching.empty());                              // the floor holds it, not the ramp
  EXPECT_EQ(bumped(layout.marker(), 2, -1, 0).at, (Vec{0, 600}));  // up the ramp to the strip's left edge
}

TEST(Bump, MovesAroundACornerThatOnlyTouches) {  // the corner blocks neither way: it must not stop there
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {500, 500}).put(square, {600, 600});  // corner to corner
  EXPECT_EQ(bumped(layout.marker(), 1, -1, 0).at, (Vec{0, 600}));
  EXPECT_EQ(bumped(layout.marker(), 1, 0, -1).at, (Vec{600, 0}));
}

TEST(Bump, DoesNotMoveLockedPieces) {
  Layout layout{1000};
  layout.put(layout.shape_of(test::rectangle(300, 200)), {5000, 400}, 0, true);
  EXPECT_EQ(bumped(layout.marker(), 0, -1, 0).at, (Vec{5000, 400}));
}

// The sum of two combs of 200 teeth takes seconds.
TEST(Bump, IsCancelledWhileItsSumIsComputed) {
  Layout layout{4'000'000};
  test::Random random{5};
  const auto comb = layout.shape_of(test::random_comb(random, 200, 1'000'000, true));
  layout.put(comb, {0, 0}).put(comb, {1'000'000, 3'500'000}, 180);
  const Marker marker = layout.marker();
  SumCache sums;
  std::stop_source source;
  const std::jthread later{[&] {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    source.request_stop();
  }};
  const auto stopped = repair_and_bump(marker, PieceId{0}, 0, 1, {sums, source.get_token()});
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_TRUE(is_valid(stopped->marker));
  EXPECT_EQ(sums.counts().entries, 0U);
}

TEST(Bump, StaysWhenCancelled) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {5000, 400}).put(square, {0, 400});
  const Marker marker = layout.marker();
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto stopped = repair_and_bump(marker, PieceId{0}, -1, 0, {sums, source.get_token()});
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(stopped->marker, marker);
  const auto whole = repair_and_bump(marker, PieceId{0}, -1, 0, {sums});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->reason, scene::StopReason::kConverged);
  EXPECT_LT(whole->bump.at.x, 200);
}

TEST(Bump, KeepsTheSpacing) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {700, 50}).spaced(7);
  const Bump left = bumped(layout.marker(), 1, -1, 0);
  EXPECT_EQ(left.at.x, 107);
  EXPECT_EQ(left.touching, (std::vector<PieceId>{PieceId{0}}));
}

TEST(Bump, UsesTheAllowance) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {700, 50}).overlapping(7);
  const Bump left = bumped(layout.marker(), 1, -1, 0);
  EXPECT_EQ(left.at.x, 93);
  EXPECT_EQ(left.touching, (std::vector<PieceId>{PieceId{0}}));
}

TEST(Bump, RepairsSmallOverlapsFirst) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {99'990, 50'000});  // they overlap by less than the healing limit
  SumCache sums;
  const auto bumped = repair_and_bump(layout.marker(), PieceId{1}, 0, 1, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->repair.pairs, 1U);
  EXPECT_TRUE(marker::is_valid(bumped->marker));
  EXPECT_EQ(bumped->marker.pieces[1].at, bumped->bump.at);
  EXPECT_EQ(bumped->bump.at.y, 900'000);
  layout.put(square, {50'000, 0});
  EXPECT_EQ(repair_and_bump(layout.marker(), PieceId{1}, 0, 1, {sums}).error().code, ErrorCode::kMarkerOverlaps);
}

// The best point that can be reached from `at` by sliding straight for at most `reach` lattice units, found by trying
// all directions and every lattice point near them.  A local optimum must not be worse.  Free points behind a passage
// narrower than the lattice cannot be reached.
double best_small_gain(const Marker& marker, std::uint32_t piece, double ux, double uy, int reach) {
  const Coord end = length_of(marker);
  double best = 0;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2 * std::numbers::pi * k / 64;
    for (int way = 1; way <= reach; ++way) {
      const Vec by{std::llround(way * std::cos(angle)), std::llround(way * std::sin(angle))};
      Marker moved = marker;
      moved.pieces[piece].at = marker.pieces[piece].at + by;
      if (box_of(placed_outline(moved, PieceId{piece})).high.x > end || !is_valid(moved)) break;
      best = std::max(best, ux * static_cast<double>(by.x) + uy * static_cast<double>(by.y));
    }
  }
  return best;
}

TEST(Bump, ReachesTheTipOfACleft) {  // of 23 degrees, between two pieces; it once stopped 17 units before the tip
  Marker marker = test::loose_marker(846, 4, 3);
  marker.pieces[4].at = bumped(marker, 4, 0, 1).at;
  EXPECT_LE(best_small_gain(marker, 4, 0, 1, 32), 2);
}

RC_GTEST_PROP(BumpLaws, EndsAtALocalOptimum, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  const auto piece = *rc::gen::inRange<std::uint32_t>(0, 12);
  const double angle = *rc::gen::element(0.0, 0.5, 1.0, 0.3, 1.7, 1.25) * std::numbers::pi;
  const Bump result = bumped(marker, piece, std::cos(angle), std::sin(angle));
  marker.pieces[piece].at = result.at;
  // If it could move on, it would gain a good part of each step; a few units are rounding.
  RC_ASSERT(best_small_gain(marker, piece, std::cos(angle), std::sin(angle), 16) <= 4.0);
}

RC_GTEST_PROP(BumpLaws, ASecondBumpGainsNothing, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  const auto piece = *rc::gen::inRange<std::uint32_t>(0, 12);
  const double angle = *rc::gen::element(0.0, 0.5, 1.0, 0.3, 1.7, 1.25) * std::numbers::pi;
  marker.pieces[piece].at = bumped(marker, piece, std::cos(angle), std::sin(angle)).at;
  RC_ASSERT(bumped(marker, piece, std::cos(angle), std::sin(angle)).gain <= 4.0);
}

}  // namespace
}  // namespace selvage::motion::piece
