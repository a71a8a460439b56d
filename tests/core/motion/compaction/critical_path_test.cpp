#include "core/motion/compaction/critical_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::compaction {
namespace {

using test::Layout;

CriticalPath held(const Marker& marker) {
  SumCache sums;
  const auto result = critical_path(marker, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *result : CriticalPath{};
}
double load_on(const CriticalPath& hold, StripEdge edge) {
  double sum = 0;
  for (const LoadedContact& c : hold.contacts) sum += !c.second && c.edge == edge ? c.worth : 0;
  return sum;
}

TEST(CriticalPath, ARowOfSquaresIsHeldByEveryContact) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {100'000, 0}).put(square, {200'000, 0}).put(square, {0, 500'000});
  const CriticalPath hold = held(layout.marker());
  ASSERT_EQ(hold.contacts.size(), 4U);  // left edge, two contacts, right edge; not the square by itself
  for (const LoadedContact& c : hold.contacts) EXPECT_NEAR(c.worth, 1, 1e-6);
  EXPECT_EQ(hold.contacts.front().edge, StripEdge::kLeft);
  EXPECT_EQ(hold.contacts[1].second, PieceId{1});
  EXPECT_EQ(hold.contacts.back().edge, StripEdge::kRight);
  EXPECT_NEAR(hold.per_spacing, 2, 1e-6);
}

TEST(CriticalPath, ThePriceOfASlantedContactFollowsFromItsSlope) {
  // A right triangle that would slide up along another's long side is held down by the strip's upper edge.
  Layout layout{400'000};
  const auto ramp = layout.shape_of({{0, 0}, {400'000, 0}, {0, 400'000}});
  layout.put(ramp, {0, 0}).put(ramp, {400'000, 400'000}, 180);
  const CriticalPath hold = held(layout.marker());
  EXPECT_NEAR(load_on(hold, StripEdge::kLeft), 1, 1e-6);
  EXPECT_NEAR(load_on(hold, StripEdge::kRight), 1, 1e-6);
  // At 45 degrees a unit of room across the contact is worth sqrt(2) of length.
  double across = 0;
  for (const LoadedContact& c : hold.contacts) across += c.second ? c.worth : 0;
  EXPECT_NEAR(across, std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(hold.per_spacing, std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(load_on(hold, StripEdge::kTop) + load_on(hold, StripEdge::kBottom), 2,
              1e-6);  // pushed apart, up and down
}

TEST(CriticalPath, ReportsTheGainOfATilt) {
  Layout layout{1'000'000};
  const Coord run = 100'000;
  const Coord rise = 50'000;
  // A needle from its left tip to its right tip.  When it is rotated, its length decreases by its rise per radian.
  layout.put(layout.shape_of({{0, 0}, {run / 2, rise / 2 - 1000}, {run, rise}, {run / 2, rise / 2 + 1000}}),
             {0, 300'000});
  const CriticalPath hold = held(layout.marker());
  ASSERT_EQ(hold.tilts.size(), 1U);
  EXPECT_NEAR(hold.tilts[0].per_degree, static_cast<double>(rise) * std::numbers::pi / 180, 1);
}

TEST(CriticalPath, ReportsThePriceOfALock) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {150'000, 0}).put(square, {250'000, 0}).put(square, {350'000, 500'000});
  Marker marker = layout.marker();
  EXPECT_TRUE(held(marker).locks.empty());
  // The second square is locked; the third one touches it and, because the last one is free, ends the marker.
  marker.pieces[1].locked = true;
  CriticalPath hold = held(marker);
  ASSERT_EQ(hold.locks.size(), 1U);
  EXPECT_EQ(hold.locks[0].piece, PieceId{1});
  EXPECT_NEAR(hold.locks[0].per_x.value_or(0), -1, 1e-6);
  EXPECT_FALSE(hold.locks[0].per_y);
  // A locked square at the end bounds the length itself.
  marker.pieces[1].locked = false;
  marker.pieces[3].locked = true;
  hold = held(marker);
  ASSERT_EQ(hold.locks.size(), 1U);
  EXPECT_EQ(hold.locks[0].piece, PieceId{3});
  EXPECT_NEAR(hold.locks[0].per_x.value_or(0), -1, 1e-6);
  // So does a lock on another square of its group.
  marker.pieces[3].locked = false;
  marker.pieces[0].locked = true;
  marker.pieces[0].group = marker.pieces[3].group = "two";
  hold = held(marker);
  ASSERT_EQ(hold.locks.size(), 1U);
  EXPECT_EQ(hold.locks[0].piece, PieceId{0});
  EXPECT_NEAR(hold.locks[0].per_x.value_or(0), -1, 1e-6);
}

// The price of a lock is a derivative: how much shorter the marker becomes when the locked piece is moved
// slightly.
TEST(CriticalPath, ThePriceOfALockIsTheGainOfMovingThePiece) {
  Layout layout{400'000};
  const auto ramp = layout.shape_of({{0, 0}, {400'000, 0}, {0, 400'000}});
  layout.put(ramp, {0, 0}).put(ramp, {400'000, 400'000}, 180);
  Marker marker = layout.marker();
  marker.pieces[0].locked.y = true;
  marker.pieces[1].locked.y = true;
  const CriticalPath hold = held(marker);
  ASSERT_EQ(hold.locks.size(), 2U);
  EXPECT_NEAR(hold.locks[0].per_y.value_or(0), -1, 1e-6);  // downwards: at 45 degrees, a unit for a unit
  EXPECT_NEAR(hold.locks[1].per_y.value_or(0), 1, 1e-6);
  EXPECT_FALSE(hold.locks[0].per_x);
}

TEST(CriticalPath, LoadsBalanceOnCompactedMarkers) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SumCache sums;
    const auto tight = compact(test::loose_marker(seed), compaction_settings(Accuracy::kFine), {sums});
    ASSERT_TRUE(tight);
    const CriticalPath hold = held(tight->marker);
    EXPECT_NEAR(load_on(hold, StripEdge::kRight), 1, 1e-6);
    EXPECT_NEAR(load_on(hold, StripEdge::kLeft), 1, 1e-6);  // nothing else pushes along x
    for (const LoadedContact& c : hold.contacts) EXPECT_GT(c.worth, 0);
    EXPECT_GE(hold.contacts.size(), 2U);
  }
}

TEST(CriticalPath, ThePriceOfTheSpacingIsCorrect) {
  SumCache sums;
  Marker marker = test::loose_marker(3);
  marker.spacing = 1000;
  const auto tight = compact(marker, compaction_settings(Accuracy::kFine), {sums});
  ASSERT_TRUE(tight);
  const CriticalPath hold = held(tight->marker);
  Marker looser = tight->marker;
  looser.spacing -= 10;
  const auto shorter = compact(looser, compaction_settings(Accuracy::kFine), {sums});
  ASSERT_TRUE(shorter);
  EXPECT_GE(static_cast<double>(tight->length_after - shorter->length_after), 10 * hold.per_spacing - 20);
}

TEST(CriticalPath, ThePriceOfAllowancesIsCorrect) {
  SumCache sums;
  Marker marker = test::loose_marker(3);
  marker.overlap = 1000;
  const auto tight = compact(marker, compaction_settings(Accuracy::kFine), {sums});
  ASSERT_TRUE(tight);
  const CriticalPath hold = held(tight->marker);
  EXPECT_FALSE(hold.contacts.empty());
  Marker looser = tight->marker;
  looser.overlap += 10;
  const auto shorter = compact(looser, compaction_settings(Accuracy::kFine), {sums});
  ASSERT_TRUE(shorter);
  EXPECT_GE(static_cast<double>(tight->length_after - shorter->length_after), 10 * hold.per_spacing - 20);
}

TEST(CriticalPath, ReportsOnlyPiecesThatTouch) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {104'000, 0});  // 4 mm apart
  const CriticalPath hold = held(layout.marker());
  ASSERT_EQ(hold.contacts.size(), 2U);
  EXPECT_EQ(hold.contacts.front().edge, StripEdge::kLeft);
  EXPECT_EQ(hold.contacts.front().first, PieceId{0});
  EXPECT_EQ(hold.contacts.back().edge, StripEdge::kRight);
  EXPECT_EQ(hold.contacts.back().first, PieceId{1});
}

// The second square touches the line of the first one's right edge, but lies above the edge.
TEST(CriticalPath, ALineIsNotAContactBeyondItsEdge) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  layout.put(square, {0, 0}).put(square, {100'000, 103'000});
  for (const LoadedContact& c : held(layout.marker()).contacts) EXPECT_FALSE(c.second);
}

TEST(CriticalPath, CanBeCancelled) {
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto stopped = critical_path(test::loose_marker(3), {sums, source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kStoppedEarly);
}

TEST(CriticalPath, RefusesInvalidMarkers) {
  Marker marker = test::loose_marker(3);
  marker.pieces[1].at = marker.pieces[0].at;
  SumCache sums;
  EXPECT_FALSE(critical_path(marker, {sums}));
}

}  // namespace
}  // namespace selvage::motion::compaction
