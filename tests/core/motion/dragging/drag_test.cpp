#include "core/motion/dragging/drag.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::dragging {
namespace {

Marker squares(std::vector<Vec> at, Coord width) {
  Marker marker;
  marker.strip.width = width;
  marker.shapes.push_back({"square", {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, {Angle{}}, false, {}});
  for (const Vec place : at) {
    marker.pieces.push_back({std::to_string(marker.pieces.size()), ShapeId{0}, {}, place, false});
  }
  return marker;
}

TEST(Drag, AFreePositionIsTakenEvenBeyondTheEnd) {
  const Marker start = squares({{0, 0}, {1000, 0}}, 4000);
  SumCache sums;
  EXPECT_EQ(drag(start, PieceId{0}, {7000, 2500}, DragMode::kPlace, {sums}).marker.pieces[0].at, (Vec{7000, 2500}));
  EXPECT_EQ(drag(start, PieceId{0}, {-50, 9000}, DragMode::kPush, {sums}).marker.pieces[0].at, (Vec{0, 3000}));
}

TEST(Drag, PlacingLeavesTheOthersAndPushingMovesThem) {
  const Marker start = squares({{0, 1500}, {2000, 1500}, {6000, 0}}, 4000);
  const Vec wanted{1400, 1500};
  SumCache sums;
  const Drag placed = drag(start, PieceId{0}, wanted, DragMode::kPlace, {sums});
  EXPECT_FALSE(placed.pushed);
  EXPECT_TRUE(is_valid(placed.marker));
  EXPECT_GE(placed.marker.pieces[0].at.x, 1000 - 2);  // it comes as far as the other
  EXPECT_EQ(placed.marker.pieces[1].at, start.pieces[1].at);
  const Drag pushed = drag(start, PieceId{0}, wanted, DragMode::kPush, {sums});
  EXPECT_TRUE(pushed.pushed);
  EXPECT_TRUE(is_valid(pushed.marker));
  EXPECT_GE(pushed.marker.pieces[0].at.x, wanted.x - 2);
  EXPECT_GE(pushed.marker.pieces[1].at.x, 2400 - 2);
  EXPECT_EQ(pushed.marker.pieces[2].at, start.pieces[2].at);
}

TEST(Drag, AGroupFollowsItsPieceAndALockedAxisIsKept) {
  Marker start = squares({{0, 0}, {1000, 1000}, {3000, 0}}, 4000);
  start.pieces[0].group = start.pieces[1].group = "pair";
  SumCache sums;
  for (const DragMode mode : {DragMode::kPlace, DragMode::kPush}) {
    const Marker moved = drag(start, PieceId{0}, {2600, 700}, mode, {sums}).marker;
    EXPECT_TRUE(is_valid(moved));
    EXPECT_NE(moved.pieces[0].at, start.pieces[0].at);
    EXPECT_EQ(moved.pieces[1].at - moved.pieces[0].at, (Vec{1000, 1000}));
  }
  start.pieces[2].locked.y = true;
  EXPECT_EQ(drag(start, PieceId{2}, {4000, 2000}, DragMode::kPlace, {sums}).marker.pieces[2].at, (Vec{4000, 0}));
}

TEST(Drag, LockedPiecesStay) {
  Marker start = squares({{0, 0}, {1000, 0}, {0, 1000}}, 2000);
  start.pieces[1].locked = true;
  SumCache sums;
  EXPECT_EQ(drag(start, PieceId{1}, {1000, 500}, DragMode::kPush, {sums}).marker, start);
  EXPECT_EQ(drag(start, PieceId{0}, {900, 0}, DragMode::kPush, {sums}).marker.pieces[1].at, start.pieces[1].at);
}

RC_GTEST_PROP(Drag, TheMarkerStaysValidWhateverTheMoves, ()) {
  std::vector<Vec> at;
  for (Coord i = 0; i < 4; ++i) {
    for (Coord k = 0; k < 3; ++k) {
      at.push_back({1300 * i + *rc::gen::inRange<Coord>(0, 200), 1200 * k + *rc::gen::inRange<Coord>(0, 150)});
    }
  }
  Marker start = squares(at, 4000);
  start.spacing = *rc::gen::inRange<Coord>(0, 40);
  start.pieces[*rc::gen::inRange<std::size_t>(0, at.size())].buffer = *rc::gen::inRange<Coord>(0, 30);
  start.pieces[*rc::gen::inRange<std::size_t>(0, at.size())].locked = true;
  RC_PRE(is_valid(start));
  const PieceId piece{*rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(at.size()))};
  const Vec to{*rc::gen::inRange<Coord>(-500, 7000), *rc::gen::inRange<Coord>(-500, 4500)};
  SumCache sums;
  for (const DragMode mode : {DragMode::kPlace, DragMode::kPush}) {
    const Drag done = drag(start, piece, to, mode, {sums});
    RC_ASSERT(is_valid(done.marker));
    SumCache other;
    RC_ASSERT(drag(start, piece, to, mode, {other}).marker == done.marker);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (start.pieces[i].locked || (mode == DragMode::kPlace && i != piece.value)) {
        RC_ASSERT(done.marker.pieces[i].at == start.pieces[i].at);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::motion::dragging
