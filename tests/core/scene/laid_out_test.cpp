#include "core/scene/laid_out.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/piece/bump.h"
#include "tests/core/motion/markers.h"

namespace selvage::scene {
namespace {

// Columns of squares with room between them.
Marker loose_squares(Coord pieces) {
  test::Layout layout{500'000};
  const auto square = layout.shape_of(test::rectangle(100'000, 100'000));
  for (Coord i = 0; i < pieces; ++i) layout.put(square, {150'000 * (i / 4), 120'000 * (i % 4)});
  return layout.marker();
}

void expect_same(const marker::Figures& a, const marker::Figures& b) {
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.utilisation, b.utilisation);
  EXPECT_EQ(a.valid, b.valid);
}

TEST(LaidOut, KnowsTheMarkersFigures) {
  SumCache sums;
  Marker marker = loose_squares(8);
  expect_same(LaidOut(marker, sums).figures, figures_of(marker));
  EXPECT_TRUE(LaidOut(marker, sums).figures.valid);
  marker.pieces[1].at = marker.pieces[0].at;
  expect_same(LaidOut(marker, sums).figures, figures_of(marker));
  EXPECT_FALSE(LaidOut(marker, sums).figures.valid);
}

// Motions from a laid-out marker are the same as those from the marker itself, whether it is valid, needs repair or is
// refused.
TEST(LaidOut, GivesTheSameMotions) {
  for (const Coord into : {0, 1, 900}) {
    Marker marker = loose_squares(8);
    marker.pieces[3].at.y -= 20'000 + into;
    SumCache sums;
    const LaidOut laid_out{marker, sums};
    const auto bumped = motion::piece::repair_and_bump(marker, laid_out, PieceId{5}, -1, 0.2, {sums});
    const auto serial = motion::piece::repair_and_bump(marker, PieceId{5}, -1, 0.2, {sums});
    ASSERT_EQ(bool(bumped), into < 900);
    ASSERT_EQ(bool(serial), bool(bumped));
    if (bumped) {
      EXPECT_EQ(bumped->marker, serial->marker);
      EXPECT_EQ(bumped->repair.pairs, into == 0 ? 0U : 1U);
      EXPECT_TRUE(is_valid(bumped->marker));
    }
    for (const motion::dragging::DragMode mode :
         {motion::dragging::DragMode::kPlace, motion::dragging::DragMode::kPush}) {
      EXPECT_EQ(drag(marker, laid_out, PieceId{5}, {70'000, 70'000}, mode, {sums}).marker,
                drag(marker, PieceId{5}, {70'000, 70'000}, mode, {sums}).marker);
    }
  }
}

// Its figures are correct however many pieces have moved, have been rotated or need more clearance.
TEST(LaidOut, KnowsTheFiguresOfLaterMarkers) {
  SumCache sums;
  int valid = 0;
  for (const bool begins_valid : {true, false}) {
    Marker before = loose_squares(40);
    if (!begins_valid) before.pieces[39].at = before.pieces[38].at;
    const LaidOut laid_out{before, sums};
    ASSERT_EQ(laid_out.figures.valid, begins_valid);
    for (std::size_t moved = 0; moved <= 40; moved += 5) {
      for (const Coord by : {10'000, 30'000, 60'000}) {
        Marker after = before;
        for (std::size_t i = 0; i < moved; ++i) after.pieces[i].at.x += i % 2 == 0 ? by : 0;
        expect_same(figures_after(before, laid_out, after), figures_of(after));
        if (moved > 0) after.pieces[moved / 2].buffer = by;
        expect_same(figures_after(before, laid_out, after), figures_of(after));
        if (moved > 0) after.pieces[moved - 1].orientation.tilt = Angle::of_degrees(2);
        expect_same(figures_after(before, laid_out, after), figures_of(after));
        valid += figures_of(after).valid;
      }
    }
  }
  EXPECT_GT(valid, 3);
}

}  // namespace
}  // namespace selvage::scene
