#include "core/motion/baseline/velocity.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/marker/validity.h"
#include "core/motion/baseline/collision.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::baseline {
namespace {

using test::Layout;

// The time until a square of size 100 at r, with this velocity, meets a square at the origin.
double meeting(Vec r, RealVec velocity, double clearance = 0) {
  SumCache sums;
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {500, 500});
  const scene::Scene scene{layout.marker(), sums};
  return collision_time(scene.obstacle({0, 1}), {r, {}}, velocity, {clearance, clearance + 0.5, 10'000});
}

TEST(CollisionTime, IsWhenTheFirstContactHappens) {
  EXPECT_DOUBLE_EQ(meeting({350, 20}, {-1, 0}), 250);
  EXPECT_DOUBLE_EQ(meeting({350, 20}, {-0.5, 0.1}), 500);
  EXPECT_DOUBLE_EQ(meeting({-300, 0}, {1, 0}), 200);
  EXPECT_DOUBLE_EQ(meeting({40, 300}, {0, -2}), 100);
  EXPECT_DOUBLE_EQ(meeting({350, 20}, {-1, 0}, 10), 240);
}

TEST(CollisionTime, IsTheHorizonWithoutACollision) {
  EXPECT_EQ(meeting({350, 20}, {1, 0}), 10'000);
  EXPECT_EQ(meeting({350, 20}, {0, 0}), 10'000);
  EXPECT_EQ(meeting({350, 200}, {-1, 0}), 10'000);  // passes over it
  EXPECT_EQ(meeting({100, 20}, {0, 1}), 10'000);    // slides along it
}

TEST(Velocity, PushesARowTogether) {
  Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {80'000, 0}).put(square, {35'000, 500}).put(square, {2'000, 9'000});
  SumCache sums;
  const auto result = compact_by_velocities(layout.marker(), {}, {sums});
  ASSERT_TRUE(result);
  EXPECT_TRUE(marker::is_valid(result->marker));
  // They remain in a row, because nothing in the model moves them into a column; clearances are a few units.
  EXPECT_NEAR(static_cast<double>(result->length_after), 30'000, 30);
  EXPECT_EQ(result->reason, scene::StopReason::kConverged);
  EXPECT_GT(result->programs, 2);
}

TEST(Velocity, StopsWhenCancelledAndAtTheWorkLimit) {
  const Marker marker = test::loose_marker(7);
  SumCache sums;
  std::stop_source source;
  scene::Observer observer;
  observer.on_round = [&](const scene::Round& round) {
    if (round.number == 2) source.request_stop();
  };
  const auto stopped = compact_by_velocities(marker, {}, {sums, source.get_token(), observer});
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(stopped->rounds, 2);
  EXPECT_TRUE(is_valid(stopped->marker));
  const auto limited = compact_by_velocities(marker, {.steps = 3}, {sums});
  EXPECT_EQ(limited->reason, scene::StopReason::kWorkLimit);
  EXPECT_EQ(limited->rounds, 3);
}

RC_GTEST_PROP(VelocityLaws, ValidNeverLongerLocksHold, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  marker.spacing = *rc::gen::element<Coord>(0, 0, 500);
  marker.pieces[*rc::gen::inRange<std::size_t>(0, 12)].locked = true;
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto result = compact_by_velocities(marker, {.steps = 40}, {sums});
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  RC_ASSERT(result->reason == scene::StopReason::kConverged || result->reason == scene::StopReason::kWorkLimit);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    RC_ASSERT(!marker.pieces[k].locked || result->marker.pieces[k].at == marker.pieces[k].at);
  }
}

RC_GTEST_PROP(VelocityLaws, GroupsAxisLocksAndBuffersHold, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  const auto p = *rc::gen::inRange<std::size_t>(0, 11);
  const auto q = *rc::gen::inRange<std::size_t>(0, 12);
  marker.pieces[p].group = marker.pieces[p + 1].group = "g";
  marker.pieces[q].locked = Locks{false, true, false};
  marker.pieces[*rc::gen::inRange<std::size_t>(0, 12)].buffer = 300;
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto result = compact_by_velocities(marker, {.steps = 40}, {sums});
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  const auto moved = [&](std::size_t k) { return result->marker.pieces[k].at - marker.pieces[k].at; };
  RC_ASSERT(moved(p) == moved(p + 1));
  RC_ASSERT(moved(q).y == 0);
}

}  // namespace
}  // namespace selvage::motion::baseline
