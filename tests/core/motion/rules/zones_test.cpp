// Zones in motions: only pieces that accept a zone's quality may lie on it.
#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/piece/bump.h"
#include "core/motion/piece/relax.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "tests/core/motion/rules/ruled_markers.h"

namespace selvage::motion {
namespace {

using namespace test_rules;

// Two squares, and between them a flaw with too little room before it for the second.
Marker flawed(Coord width) {
  Marker marker = squares({{50'000, 0}, {400'000, 0}, {150'000, 0}});
  marker.strip.width = width;
  marker.pieces[2].rules.zone = true;
  return *make_marker(std::move(marker));
}

TEST(Rules, CompactionStopsAtAZoneAndReportsItsPrice) {
  const Marker tight = compacted(flawed(kSide));
  EXPECT_EQ(tight.pieces[0].at.x, 0);
  EXPECT_EQ(tight.pieces[1].at.x, 250'000);
  EXPECT_EQ(tight.pieces[2].at.x, 150'000);
  EXPECT_EQ(length_of(tight), 350'000);
  const auto path = held(tight);
  ASSERT_EQ(path.locks.size(), 1U);
  EXPECT_EQ(path.locks[0].piece, PieceId{2});
  EXPECT_NEAR(path.locks[0].per_x.value_or(0), -1, 1e-6);
}

TEST(Rules, AZoneHoldsBackOnlyPiecesThatDoNotAcceptItsQuality) {
  Marker marker = flawed(kSide);
  marker.pieces[2].rules.quality = 2;
  EXPECT_EQ(length_of(compacted(marker)), 350'000);
  marker.pieces[1].rules.quality = 1;
  const Marker tight = compacted(marker);
  EXPECT_EQ(length_of(tight), 350'000);
  EXPECT_NEAR(held(tight).locks.at(0).per_x.value_or(0), -1, 1e-6) << "the zone costs what a flaw would";
  marker.pieces[1].rules.quality = 2;
  const Marker tighter = compacted(marker);
  EXPECT_EQ(length_of(tighter), 200'000);
  EXPECT_TRUE(held(tighter).locks.empty());
}

TEST(Rules, EveryMotionOfOnePieceGoesOverZonesThatItAccepts) {
  Marker marker = flawed(10 * kSide);
  marker.pieces[2].rules.quality = 1;
  marker.pieces[1].rules.quality = 1;
  SumCache sums;
  for (const auto mode : {dragging::DragMode::kPlace, dragging::DragMode::kPush}) {
    const auto dragged = dragging::drag(marker, PieceId{1}, {180'000, 20'000}, mode, {sums}).marker;
    EXPECT_EQ(dragged.pieces[1].at, (Vec{180'000, 20'000}));
    EXPECT_TRUE(is_valid(dragged));
  }
  const auto placed = placing::repair_and_place(marker, PieceId{1}, {210'000, 50'000}, {}, {sums});
  ASSERT_TRUE(placed && placed->place);
  EXPECT_EQ(placed->place->at, (Vec{210'000, 50'000}));
  const auto bumped = piece::repair_and_bump(marker, PieceId{1}, -1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[1].at.x, 150'000) << "the first square stops it";
  marker.pieces[0].at = {110'000, 10'000};
  marker.pieces[1].at = {170'000, 30'000};
  marker.pieces[0].rules.quality = 1;
  const auto apart = separation::separate(marker, {.rounds = 60, .grow = 1}, {sums});
  ASSERT_TRUE(apart) << apart.error().message;
  EXPECT_TRUE(is_valid(apart->marker));
}

// The second square accepts the zone's cloth, but for three quarters of it on its left.
Marker with_part(Coord width) {
  Marker marker = flawed(width);
  marker.pieces[2].rules.quality = 2;
  marker.pieces[1].rules.quality = 2;
  marker.pieces[1].rules.part = marker::Part{test::rectangle(3 * kSide / 4, kSide), 1};
  return *make_marker(std::move(marker));
}

TEST(Rules, CompactionLaysWhatAcceptsAZoneOntoItAndThePartBesideIt) {
  // The zone from 150,000 to 250,000 fills the strip, so the square's part has to lie behind it.
  const Marker tight = compacted(with_part(kSide));
  EXPECT_EQ(tight.pieces[1].at.x, 250'000);
  EXPECT_NEAR(held(tight).locks.at(0).per_x.value_or(0), -1, 1e-6) << "the zone costs what it costs the part";
  // Turned by 180 degrees, the part is on the square's right; the rest of it lies on the zone.
  Marker turned = with_part(kSide);
  turned.shapes[0].rotations = {{0}, {180}};
  turned.pieces[1].orientation.rotation = {180};
  turned.pieces[1].at = {400'000 + kSide, kSide};
  const Marker short_of_it = compacted(turned);
  EXPECT_EQ(length_of(short_of_it), 250'000 + 3 * kSide / 4);
  turned.pieces[2].at.x = 600'000;
  EXPECT_EQ(length_of(compacted(turned)), 200'000);
}

TEST(Rules, EveryMotionOfOnePieceKeepsItsPartOffTheZone) {
  Marker marker = with_part(10 * kSide);
  marker.pieces[0].at = {600'000, 0};
  const Vec partly{70'000, 10'000};  // a quarter of it reaches over the zone, and its part to just before it
  SumCache sums;
  const auto over = dragging::drag(marker, PieceId{1}, partly, dragging::DragMode::kPlace, {sums}).marker;
  EXPECT_EQ(over.pieces[1].at, partly);
  EXPECT_TRUE(is_valid(over));
  for (const auto mode : {dragging::DragMode::kPlace, dragging::DragMode::kPush}) {
    const auto beside = dragging::drag(marker, PieceId{1}, {200'000, 50'000}, mode, {sums}).marker;
    EXPECT_TRUE(is_valid(beside));
    EXPECT_NE(beside.pieces[1].at, (Vec{200'000, 50'000})) << "its part would lie on the zone";
  }
  const auto placed = placing::repair_and_place(marker, PieceId{1}, partly, {}, {sums});
  ASSERT_TRUE(placed && placed->place);
  EXPECT_EQ(placed->place->at, partly);
  const auto bumped = piece::repair_and_bump(marker, PieceId{1}, -1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[1].at.x, 250'000) << "its part meets the zone";
  Marker spoilt = marker;
  spoilt.pieces[1].at = {170'000, 30'000};
  ASSERT_FALSE(is_valid(spoilt));
  const auto apart = separation::separate(spoilt, {.rounds = 60, .grow = 1}, {sums});
  ASSERT_TRUE(apart) << apart.error().message;
  EXPECT_TRUE(apart->apart);
  EXPECT_TRUE(is_valid(apart->marker));
  spoilt.pieces[1].at = {249'980, 0};
  EXPECT_FALSE(is_valid(spoilt));
  EXPECT_TRUE(is_valid(compacted(spoilt))) << "a small fault is repaired";
}

TEST(Rules, APartTiltsWithItsPiece) {
  Marker marker = with_part(10 * kSide);
  marker.shapes[0].tilt_limit = Angle::of_degrees(10);
  marker.pieces[1].at = {252'000, 10'000};
  SumCache sums;
  const auto relaxed = piece::repair_and_relax(marker, PieceId{1}, 9, {sums});
  ASSERT_TRUE(relaxed);
  EXPECT_TRUE(is_valid(relaxed->marker));
  const Marker tight = compacted(marker);
  EXPECT_TRUE(is_valid(tight));
}

TEST(Rules, AZoneBehindTheMarkerHasNoEffect) {
  Marker marker = flawed(kSide);
  marker.pieces[2].at.x = 600'000;
  const Marker tight = compacted(marker);
  EXPECT_EQ(length_of(tight), 200'000);
  EXPECT_TRUE(held(tight).locks.empty());
}

TEST(Rules, ASpacingDoesNotHoldPiecesOffAZone) {
  Marker marker = flawed(kSide);
  marker.spacing = 10'000;
  EXPECT_EQ(compacted(marker).pieces[1].at.x, 250'000);
}

TEST(Rules, DragsAndPlacingGoAroundZones) {
  const Marker marker = flawed(10 * kSide);
  SumCache sums;
  for (const auto mode : {dragging::DragMode::kPlace, dragging::DragMode::kPush}) {
    const auto dragged = dragging::drag(marker, PieceId{1}, {180'000, 20'000}, mode, {sums}).marker;
    EXPECT_TRUE(is_valid(dragged));
    EXPECT_EQ(dragged.pieces[2].at, marker.pieces[2].at);
  }
  const auto placed = placing::repair_and_place(marker, PieceId{1}, {210'000, 50'000}, {}, {sums});
  ASSERT_TRUE(placed && placed->place);
  EXPECT_EQ(placed->place->at.x, 250'000);
  const auto bumped = piece::repair_and_bump(marker, PieceId{1}, -1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[1].at.x, 250'000);
}

TEST(Rules, SeparationMovesPiecesOffAZone) {
  Marker marker = flawed(10 * kSide);
  marker.pieces[0].at = {110'000, 10'000};
  marker.pieces[1].at = {170'000, 30'000};
  ASSERT_FALSE(is_valid(marker));
  SumCache sums;
  const auto done = separation::separate(marker, {.rounds = 60, .grow = 1}, {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(done->apart);
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->marker.pieces[2].at, marker.pieces[2].at);
}

TEST(Rules, RepairMovesAPieceOffAZone) {
  Marker marker = flawed(10 * kSide);
  marker.pieces[1].at.x = 249'980;
  EXPECT_FALSE(is_valid(marker));
  EXPECT_TRUE(is_valid(compacted(marker)));
}

}  // namespace
}  // namespace selvage::motion
