// Tests of core/nesting/layout: kinds, orientations, movable pieces, and conversion to a marker and back.
#include "core/nesting/layout/piece_set.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/nesting/layout/layout.h"
#include "tests/core/nesting/unplaced_pieces.h"
#include "tests/laws/random_marker.h"

namespace selvage::nesting::layout {
namespace {

using test::kWidth;

Marker bars(std::size_t pieces) {
  return test::unplaced_pieces({test::rectangle(1'200'000, 100'000), test::rectangle(50'000, 50'000)}, pieces, kWidth);
}

TEST(PieceSet, LeavesOutOrientationsThatAreTooWide) {
  SumCache sums;
  const auto set = piece_set_of(bars(4), PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  ASSERT_EQ(set->kinds.size(), 2u);
  EXPECT_EQ(set->kinds[0].turned.size(), 2u);  // across the strip the bar does not fit
  EXPECT_EQ(set->kinds[1].turned.size(), 4u);
  EXPECT_NEAR(set->kinds[0].turned[0].box.width(), 1200, 1e-9);
  EXPECT_NEAR(set->kinds[0].area, 1200 * 100, 1e-6);
  EXPECT_EQ(set->outlines.size(), 2u);  // quarter turns share one base outline
}

TEST(PieceSet, RefusesAPieceThatFitsInNoOrientation) {
  Marker marker = bars(4);
  marker.strip.margin = 460'000;
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().code, ErrorCode::kPieceTooWide);
  EXPECT_EQ(set.error().field, "/unplaced/0");
}

TEST(PieceSet, ALockedOrientationIsTheOnlyOne) {
  Marker marker = bars(4);
  marker.unplaced[3].locked.tilt = true;
  marker.unplaced[3].orientation.rotation = {90};
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  ASSERT_EQ(set->kinds.size(), 3u);
  ASSERT_EQ(set->kind(3).turned.size(), 1u);
  EXPECT_EQ(set->kind(3).turned[0].orientation.rotation, Angle::of_degrees(90));
}

TEST(PieceSet, AShapeThatMayTurnFreelyIsTriedInSomeRotations) {
  Marker marker = bars(4);
  marker.shapes[1].rotations.clear();
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->kinds[1].turned.size(), static_cast<std::size_t>(kFreeRotations));
  EXPECT_EQ(set->outlines.size(), 6u);  // the bar, and the square at 0, 22.5, 45, -22.5 and -45 degrees
}

TEST(PieceSet, LockedAndGroupedPiecesAreFixed) {
  Marker marker = bars(4);
  for (Piece& piece : marker.unplaced) marker.pieces.push_back(piece);
  marker.unplaced.clear();
  marker.pieces[0].locked.y = true;
  marker.pieces[1].group = "pair";
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->fixed, (std::vector<bool>{true, true, false, false}));
  const auto held = piece_set_of(marker, PlacedPiecesMay::kNotMove, sums);
  ASSERT_TRUE(held);
  EXPECT_EQ(held->fixed, (std::vector<bool>{true, true, true, true}));
}

// Rotations other than multiples of 90 degrees, flips, tilts and locks survive conversion to a layout and back.
TEST(Layout, IsTheMarkerUpToRounding) {
  test::Random random{1};
  for (int trial = 0; trial < 50; ++trial) {
    const Marker marker = test::random_marker(random);
    SumCache sums;
    const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
    ASSERT_TRUE(set) << set.error().message;
    const Marker back = to_marker(*set, to_layout(*set, marker), marker);
    ASSERT_EQ(back.pieces.size(), marker.pieces.size());
    for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
      const Piece& was = marker.pieces[i];
      const Piece& is = back.pieces[i];
      EXPECT_EQ(is.id, was.id);
      EXPECT_TRUE(!set->fixed[i] || is == was);
      if (was.orientation.tilt.degrees != 0) continue;  // laid without its tilt
      EXPECT_EQ(is.orientation, was.orientation);
      EXPECT_LE(std::abs(is.at.x - was.at.x), 1);
      EXPECT_LE(std::abs(is.at.y - was.at.y), 1);
    }
  }
}

TEST(Layout, SettingTheLengthMovesWhatLiesBeyondTheSplit) {
  const Marker marker = test::unplaced_pieces({test::rectangle(100'000, 100'000)}, 3, kWidth);
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  Layout layout;
  layout.length = 1000;
  layout.places = {{0, 0, 0}, {400, 0, 0}, {900, 950, 0}};
  set_length(*set, layout, 900, 425);
  EXPECT_EQ(layout.places[0].x, 0);
  EXPECT_EQ(layout.places[1].x, 300);
  EXPECT_EQ(layout.places[2].x, 800);
  EXPECT_EQ(layout.places[2].y, 900);  // back within the strip
}

TEST(Layout, StretchingMovesTheMiddlesOfPiecesApart) {
  Marker marker = test::unplaced_pieces({test::rectangle(100'000, 100'000)}, 2, kWidth);
  marker.pieces = {test::unplaced_pieces({test::rectangle(100'000, 100'000)}, 1, kWidth).unplaced[0]};
  marker.pieces[0].id = "locked";
  marker.pieces[0].locked = {true, true, true};
  SumCache sums;
  const auto set = piece_set_of(marker, PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  Layout layout;
  layout.length = 1000;
  layout.places = {{200, 0, 0}, {100, 300, 0}, {900, 0, 0}};
  stretch(*set, layout, 1.5);
  EXPECT_EQ(layout.length, 1500);
  EXPECT_EQ(layout.places[0].x, 200);  // fixed
  EXPECT_EQ(layout.places[1].x, 175);  // its middle was at 150, and is at 225
  EXPECT_EQ(layout.places[1].y, 300);
  EXPECT_EQ(layout.places[2].x, 1375);
}

}  // namespace
}  // namespace selvage::nesting::layout
