#include "core/motion/placing/align.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::placing {
namespace {

using test::Layout;

Alignment aligned(const Marker& marker, std::vector<PieceId> pieces, StripEdge side) {
  SumCache sums;
  auto done = align(marker, pieces, side, {sums});
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_LE(done->length_after, done->length_before);
  return *std::move(done);
}

// Three squares of different sizes, one above the other, a step apart.
Marker stair() {
  Layout layout{1000};
  layout.put(layout.shape_of(test::rectangle(100, 100)), {50, 0});
  layout.put(layout.shape_of(test::rectangle(200, 200)), {300, 200});
  layout.put(layout.shape_of(test::rectangle(300, 300)), {150, 500});
  return layout.marker();
}

TEST(Align, PutsTheSidesOnTheLineOfTheOutermost) {
  const Alignment left = aligned(stair(), {{0}, {1}, {2}}, StripEdge::kLeft);
  EXPECT_EQ(left.line, 50);
  EXPECT_EQ(left.aligned, 3U);
  for (const Piece& piece : left.marker.pieces) EXPECT_EQ(piece.at.x, 50);
  EXPECT_EQ(left.marker.pieces[1].at.y, 200);
  EXPECT_EQ(left.length_after, 350);

  const Alignment right = aligned(stair(), {{0}, {2}}, StripEdge::kRight);
  EXPECT_EQ(right.line, 450);
  EXPECT_EQ(right.marker.pieces[0].at, (Vec{350, 0}));
  EXPECT_EQ(right.marker.pieces[1], stair().pieces[1]);
}

TEST(Align, MovesPiecesAsFarAsThereIsRoom) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {200, 0}).put(square, {600, 50});
  const Alignment done = aligned(layout.marker(), {{0}, {2}}, StripEdge::kLeft);
  EXPECT_EQ(done.aligned, 1U);
  EXPECT_EQ(done.marker.pieces[2].at, (Vec{100, 50}));
}

// The aligned position is free, though a piece lies on the way to it.
TEST(Align, PassesPiecesInBetween) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 200}).put(square, {200, 0}).put(square, {600, 50});
  const Alignment done = aligned(layout.marker(), {{0}, {2}}, StripEdge::kLeft);
  EXPECT_EQ(done.aligned, 2U);
  EXPECT_EQ(done.marker.pieces[2].at, (Vec{0, 50}));
}

TEST(Align, MovesGroupsWholeAndLeavesLockedPieces) {
  Marker marker = stair();
  marker.pieces[1].group = marker.pieces[2].group = "g";
  const Alignment grouped = aligned(marker, {{0}, {2}}, StripEdge::kLeft);
  EXPECT_EQ(grouped.marker.pieces[2].at, (Vec{50, 500}));
  EXPECT_EQ(grouped.marker.pieces[1].at, (Vec{200, 200}));

  marker = stair();
  marker.pieces[1].locked.x = true;
  const Alignment locked = aligned(marker, {{0}, {1}, {2}}, StripEdge::kLeft);
  EXPECT_EQ(locked.aligned, 2U);
  EXPECT_EQ(locked.marker.pieces[1], marker.pieces[1]);
}

// The cloth goes on behind the marker, and the other piece of the group lies at the marker's end.
TEST(Align, DoesNotLengthenAMarkerWhoseClothEndsLater) {
  Marker marker = stair();
  marker.strip.longest = 1000;
  marker.pieces[0].group = marker.pieces[1].group = "g";
  const Alignment done = aligned(marker, {{0}, {2}}, StripEdge::kRight);
  EXPECT_EQ(done.length_after, 500);
  EXPECT_EQ(done.aligned, 1U);
}

TEST(Align, RepeatedChangesNothing) {
  const Alignment once = aligned(stair(), {{0}, {1}, {2}}, StripEdge::kTop);
  EXPECT_EQ(aligned(once.marker, {{0}, {1}, {2}}, StripEdge::kTop).marker, once.marker);
}

TEST(Align, RefusesASinglePiece) {
  SumCache sums;
  const std::vector<PieceId> one{{0}};
  const auto done = align(stair(), one, StripEdge::kLeft, {sums});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kOutOfRange);
  EXPECT_EQ(done.error().field, "/pieces");
}

}  // namespace
}  // namespace selvage::motion::placing
