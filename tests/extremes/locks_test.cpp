// Locks that leave no freedom, and locks that contradict each other.
#include <gtest/gtest.h>

#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/pins/pins.h"
#include "tests/support/garment.h"

namespace selvage::test {
namespace {

using test::reached;

TEST(ExtremeLocks, EverythingLockedStaysToTheLastBit) {
  Marker marker = test::garment("jeans_02g");
  for (Piece& piece : marker.pieces) piece.locked = true;
  EXPECT_EQ(test::soundly_compacted(marker).marker, marker);
  SumCache sums;
  const auto tilted =
      tilt(marker, tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard),
           {sums});
  ASSERT_TRUE(tilted);
  EXPECT_EQ(tilted->marker.pieces, marker.pieces);
  const auto floated = float_apart(marker, float_settings(motion::floating::FloatMode::kTwoStep, 1000), {sums});
  ASSERT_TRUE(floated);
  EXPECT_EQ(floated->marker, marker);
  const auto separated = motion::separation::separate(marker, {}, {sums});
  ASSERT_TRUE(separated);
  EXPECT_EQ(separated->marker, marker);
  const auto bumped = motion::piece::repair_and_bump(marker, PieceId{0}, -1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker, marker);
  EXPECT_EQ(drag(marker, PieceId{0}, {0, 0}, motion::dragging::DragMode::kPush, {sums}).marker, marker);
  reached("locked pieces", static_cast<double>(marker.pieces.size()));
}

// Half of the pieces are locked along x and the others along y; pieces move only along their free axis.
TEST(ExtremeLocks, EveryPieceLockedOnOneAxis) {
  Marker marker = test::garment("jeans_06g");
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) marker.pieces[k].locked = {k % 2 == 0, k % 2 == 1, false};
  const motion::compaction::Compaction result = test::soundly_compacted(marker);
  const double ratio = static_cast<double>(result.length_after) / static_cast<double>(result.length_before);
  reached("after / before", ratio);
  expect_pinned("extremes", "every piece locked on one axis", ratio);
}

// Two locked pieces that overlap by `overlap` units, and a free one.
Marker contradiction(Coord overlap) {
  constexpr Coord kSide = 100'000'000;
  test::Layout layout{2 * kSide};
  const auto square = layout.shape_of(test::rectangle(kSide, kSide));
  layout.put(square, {0, 0}, 0, true).put(square, {kSide - overlap, 0}, 0, true).put(square, {3 * kSide, 0});
  return layout.marker();
}

TEST(ExtremeLocks, LockedPiecesThatOverlapAreRefusedByName) {
  for (const Coord overlap : {Coord{1}, Coord{1000}, Coord{10'000'000}}) {
    SCOPED_TRACE(overlap);
    const Marker marker = contradiction(overlap);
    const Marker before = marker;
    SumCache sums;
    const auto result = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().code == ErrorCode::kRepairFailed || result.error().code == ErrorCode::kMarkerOverlaps);
    EXPECT_NE(result.error().message.find("p0"), std::string::npos) << result.error().message;
    EXPECT_NE(result.error().message.find("p1"), std::string::npos) << result.error().message;
    EXPECT_EQ(marker, before);
    reached(std::to_string(overlap) + " units", result.error().message);

    const auto separated =
        motion::separation::separate(marker, {}, {sums});  // which reports the overlaps that it cannot remove
    ASSERT_TRUE(separated);
    EXPECT_FALSE(separated->apart);
    ASSERT_EQ(separated->remaining.size(), 1U);
    EXPECT_EQ(separated->remaining[0].first, PieceId{0});
    EXPECT_EQ(separated->remaining[0].second, PieceId{1});
    EXPECT_EQ(separated->marker.pieces[0], marker.pieces[0]);
    EXPECT_EQ(separated->marker.pieces[1], marker.pieces[1]);
  }
}

TEST(ExtremeLocks, ALockedPieceAUnitOutsideTheStripIsRefusedByName) {
  Marker marker = contradiction(0);
  marker.pieces[0].at = {0, -1};
  SumCache sums;
  const auto result = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  ASSERT_FALSE(result);
  reached("a unit outside", result.error().message);
  EXPECT_EQ(result.error().code, ErrorCode::kRepairFailed);
  EXPECT_EQ(result.error().field, "/pieces/0/at");
  EXPECT_NE(result.error().message.find("\"p0\" leaves the strip by 0.001 mm"), std::string::npos);
  const auto separated = motion::separation::separate(marker, {}, {sums});
  ASSERT_FALSE(separated);
  EXPECT_EQ(separated.error().code, ErrorCode::kOutsideStrip);
}

}  // namespace
}  // namespace selvage::test
