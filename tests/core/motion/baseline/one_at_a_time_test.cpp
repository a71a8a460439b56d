#include "core/motion/baseline/one_at_a_time.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::baseline {
namespace {

using test::Layout;

TEST(OneAtATime, PushesARowTogether) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {800, 0}).put(square, {350, 0}).put(square, {20, 0});  // not in the order in which they lie
  SumCache sums;
  int rounds = 0;
  scene::Observer observer;
  observer.on_round = [&](const scene::Round& round) { rounds = round.number; };
  const auto result = compact_one_at_a_time(layout.marker(), {}, {sums, {}, observer});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->length_before, 900);
  EXPECT_EQ(result->length_after, 300);
  EXPECT_EQ(result->reason, scene::StopReason::kConverged);
  EXPECT_EQ(result->rounds, rounds);
  EXPECT_EQ(result->programs, 0);
}

// A wedge points between two blocks; it can only advance while the upper block rises.
TEST(OneAtATime, CannotMakeMovesThatRequireTwoPieces) {
  Layout layout{304'000};
  const auto wedge = layout.shape_of({{0, 0}, {100'000, 50'000}, {0, 100'000}});
  const auto block = layout.shape_of(test::rectangle(100'000, 148'000));
  layout.put(block, {0, 0}).put(block, {0, 152'000}).put(wedge, {196'000, 200'000}, 180);
  ASSERT_TRUE(marker::is_valid(layout.marker()));
  SumCache sums;
  const auto serial = compact_one_at_a_time(layout.marker(), {}, {sums});
  const auto together = compact(layout.marker(), compaction_settings(compaction::Accuracy::kFine), {sums});
  EXPECT_EQ(serial->length_after, 196'000);
  EXPECT_LE(together->length_after, 192'010);
}

TEST(OneAtATime, StopsWhenCancelledAndAtTheWorkLimit) {
  const Marker marker = test::loose_marker(7);
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto stopped = compact_one_at_a_time(marker, {}, {sums, source.get_token()});
  EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(stopped->marker, marker);
  const auto limited = compact_one_at_a_time(marker, {.sweeps = 1}, {sums});
  EXPECT_EQ(limited->reason, scene::StopReason::kWorkLimit);
  EXPECT_EQ(limited->rounds, 1);
}

RC_GTEST_PROP(OneAtATimeLaws, ValidNeverLongerLocksHold, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  marker.spacing = *rc::gen::element<Coord>(0, 500);
  marker.pieces[*rc::gen::inRange<std::size_t>(0, 12)].locked = true;
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto result = compact_one_at_a_time(marker, {.sweeps = 3}, {sums});
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    const Vec by = result->marker.pieces[k].at - marker.pieces[k].at;
    RC_ASSERT(by.x <= 0);
    RC_ASSERT(!marker.pieces[k].locked || by == Vec{});
  }
}

RC_GTEST_PROP(OneAtATimeLaws, GroupsAxisLocksAndBuffersHold, ()) {
  Marker marker = test::loose_marker(*rc::gen::arbitrary<std::uint32_t>(), 4, 3);
  const auto p = *rc::gen::inRange<std::size_t>(0, 11);
  const auto q = *rc::gen::inRange<std::size_t>(0, 12);
  marker.pieces[p].group = marker.pieces[p + 1].group = "g";
  marker.pieces[q].locked = Locks{false, true, false};
  marker.pieces[*rc::gen::inRange<std::size_t>(0, 12)].buffer = 300;
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto result = compact_one_at_a_time(marker, {.sweeps = 3}, {sums});
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  const auto moved = [&](std::size_t k) { return result->marker.pieces[k].at - marker.pieces[k].at; };
  RC_ASSERT(moved(p) == moved(p + 1));
  RC_ASSERT(moved(q).y == 0);
}

}  // namespace
}  // namespace selvage::motion::baseline
