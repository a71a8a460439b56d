// Bands, selvedges, folds and shades in motions: they are kept, they restrict no more than specified, and their prices
// are correct.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/piece/bump.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "tests/core/motion/rules/ruled_markers.h"

namespace selvage::motion {
namespace {

using namespace test_rules;

TEST(Rules, CompactionStopsAtTheBeginningOfABand) {
  Marker marker = squares({{500'000, 0}, {500'000, 300'000}});
  marker.pieces[0].rules.from = 300'000;
  const Marker tight = compacted(marker);
  EXPECT_EQ(tight.pieces[0].at.x, 300'000);
  EXPECT_EQ(tight.pieces[1].at.x, 0);
  const auto path = held(tight);
  ASSERT_EQ(path.rules.size(), 1U);
  EXPECT_EQ(path.rules[0], (compaction::RulePrice{Rule::kFrom, PieceId{0}, path.rules[0].worth}));
  EXPECT_NEAR(path.rules[0].worth, 1, 1e-6);
  const auto at_an_edge = [](const compaction::LoadedContact& c) { return c.edge == StripEdge::kLeft && !c.second; };
  EXPECT_TRUE(std::none_of(path.contacts.begin(), path.contacts.end(), at_an_edge));
}

// Two squares behind each other, of which the second is held back by the end of its band: this must not hold back the
// first.
TEST(Rules, APieceAtTheEndOfItsBandIsNotPushedOutOfIt) {
  Marker marker = squares({{0, 0}, {200'000, 0}});
  marker.pieces[1].rules.to = 320'000;
  SumCache sums;
  const auto dragged = dragging::drag(marker, PieceId{1}, {900'000, 0}, dragging::DragMode::kPlace, {sums});
  EXPECT_EQ(dragged.marker.pieces[1].at.x, 220'000);
  const auto bumped = piece::repair_and_bump(marker, PieceId{1}, 1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[1].at.x, 200'000);  // a bump does not lengthen the marker
  const auto pushed = dragging::drag(marker, PieceId{0}, {900'000, 0}, dragging::DragMode::kPush, {sums});
  EXPECT_TRUE(is_valid(pushed.marker));
  EXPECT_LE(pushed.marker.pieces[1].at.x, 220'000);
}

TEST(Rules, SelvedgesHoldOnTheirSideOnly) {
  Marker marker = squares({{0, 500'000}, {0, 700'000}});
  marker.strip.below = 20'000;
  marker.strip.above = 50'000;
  marker.pieces[1].rules.above = 0;
  SumCache sums;
  const auto bumped = [&](std::uint32_t piece, double dy) {
    const auto done = piece::repair_and_bump(marker, PieceId{piece}, 0, dy, {sums});
    EXPECT_TRUE(done);
    return done->marker.pieces[piece].at.y;
  };
  EXPECT_EQ(bumped(0, -1), 20'000);
  EXPECT_EQ(bumped(1, 1), 900'000);
  marker.pieces[1].rules.above.reset();
  EXPECT_EQ(bumped(1, 1), 850'000);
}

const Polygon kDiamond{{100'000, 0}, {200'000, 100'000}, {100'000, 200'000}, {0, 100'000}};

// Two diamonds side to side: the one above slides to the left as far as the strip is wide.
Marker diamonds() {
  Layout layout{300'000};
  const auto diamond = layout.shape_of(kDiamond);
  layout.put(diamond, {0, 0}).put(diamond, {100'000, 100'000});
  return layout.marker();
}

TEST(Rules, ThePriceOfASelvedgeIsCorrect) {
  Marker marker = diamonds();
  EXPECT_TRUE(held(marker).rules.empty());
  marker.strip.above = 0;
  EXPECT_NEAR(worth_of(held(marker), Rule::kAbove, std::nullopt), 1, 1e-6);
  marker.pieces[0].rules.below = 0;
  EXPECT_NEAR(worth_of(held(marker), Rule::kBelow, PieceId{0}), 1, 1e-6);
  // The price of a selvedge of ten units.
  marker.strip.width += 10;
  marker.strip.above = 10;
  const Coord with = length_of(compacted(marker));
  marker.strip.above = 0;
  EXPECT_NEAR(static_cast<double>(with - length_of(compacted(marker))), 10, 3);
}

TEST(Rules, AFoldFixesAPieceAcrossTheStripAndReportsItsPrice) {
  Layout layout{250'000};
  const auto roof = layout.shape_of({{0, 0}, {200'000, 0}, {100'000, 100'000}});
  const auto diamond = layout.shape_of(kDiamond);
  layout.put(roof, {0, 0}).put(diamond, {50'000, 50'000});
  Marker marker = layout.marker();
  marker.pieces[0].rules.on_fold = true;
  EXPECT_NEAR(worth_of(held(marker), Rule::kFold, PieceId{0}), 1, 1e-6);
  Marker apart = squares({{300'000, 0}, {500'000, 300'000}});
  apart.pieces[0].rules.on_fold = true;
  const Marker tight = compacted(apart);
  EXPECT_EQ(tight.pieces[0].at, (Vec{0, 0}));
  SumCache sums;
  const auto dragged = dragging::drag(tight, PieceId{0}, {50'000, 700'000}, dragging::DragMode::kPlace, {sums});
  EXPECT_EQ(dragged.marker.pieces[0].at.y, 0);
}

// A locked square behind the others, and one of its shade, which a long piece follows.
Marker shaded() {
  Layout layout{10 * kSide};
  const auto square = layout.shape_of(test::rectangle(kSide, kSide));
  const auto beam = layout.shape_of(test::rectangle(6 * kSide, kSide));
  layout.put(square, {320'000, 0}).put(square, {500'000, 500'000}, 0, true).put(beam, {450'000, 0});
  Marker marker = layout.marker();
  marker.shade = 300'000;
  marker.pieces[0].rules.shade = marker.pieces[1].rules.shade = "A";
  return marker;
}

TEST(Rules, CompactionKeepsAShadeTogetherAndUsesAllOfItsLength) {
  const Marker tight = compacted(shaded());
  EXPECT_EQ(tight.pieces[0].at.x, 300'000);
  EXPECT_EQ(length_of(tight), 1'000'000);
  const auto path = held(tight);
  EXPECT_NEAR(worth_of(path, Rule::kShade, PieceId{0}), 1, 1e-6);
  ASSERT_EQ(path.locks.size(), 1U);  // and so is moving the locked one to the left
  EXPECT_NEAR(path.locks[0].per_x.value_or(0), -1, 1e-6);
  Marker looser = tight;
  looser.shade = 310'000;
  EXPECT_EQ(length_of(compacted(looser)), 990'000);
}

TEST(Rules, APieceReachesNoFartherThanItsShade) {
  const Marker marker = shaded();
  SumCache sums;
  const auto bumped = piece::repair_and_bump(marker, PieceId{0}, -1, 0, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[0].at.x, 300'000);
  const auto placed = placing::repair_and_place(marker, PieceId{0}, {0, 800'000}, {}, {sums});
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->marker.pieces[0].at, (Vec{300'000, 800'000}));
  const auto pushed = dragging::drag(marker, PieceId{0}, {0, 0}, dragging::DragMode::kPush, {sums});
  EXPECT_EQ(pushed.marker.pieces[0].at.x, 300'000);
}

TEST(Rules, SeparationBringsPiecesIntoTheirRoomsAndShadesTogether) {
  Marker marker = squares({{0, 50'000}, {700'000, 0}, {20'000, 120'000}, {300'000, 980'000}});
  marker.shade = 400'000;
  for (const std::size_t piece : {0, 1}) marker.pieces[piece].rules.shade = "A";
  marker.pieces[2].rules.on_fold = true;
  marker.pieces[3].rules.above = 30'000;
  ASSERT_FALSE(is_valid(marker));
  SumCache sums;
  const auto done = separation::separate(marker, {.rounds = 60, .grow = 1}, {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(done->apart);
  EXPECT_TRUE(is_valid(done->marker));
}

TEST(Rules, AShadeThatIsTooLongIsReported) {
  Marker marker = squares({{0, 0}, {700'000, 0}});
  marker.shade = 400'000;
  for (Piece& piece : marker.pieces) piece.rules.shade = "M-A";
  SumCache sums;
  const auto refused = compact(marker, compaction::compaction_settings(compaction::Accuracy::kDraft), {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "/shade");
  EXPECT_NE(refused.error().message.find("M-A"), std::string::npos);
}

TEST(Rules, RepairReturnsPiecesThatLeaveTheirRoomSlightly) {
  Marker marker = squares({{0, 0}, {300'010, 0}, {500'000, 500'000}});
  marker.shade = 400'000;
  for (const std::size_t piece : {0, 1}) marker.pieces[piece].rules.shade = "A";
  marker.pieces[2].rules.to = 599'990;
  const Marker tight = compacted(marker);
  EXPECT_TRUE(is_valid(tight));
}

TEST(Rules, PiecesOnTheUpperFoldOfATubeMoveAlongItOnly) {
  Layout layout{250'000};
  const auto roof = layout.shape_of({{0, 0}, {200'000, 0}, {100'000, 100'000}});
  const auto diamond = layout.shape_of(kDiamond);
  layout.put(roof, {300'000, 0}).put(roof, {700'000, 250'000}).put(diamond, {50'000, 40'000});
  Marker marker = layout.marker();
  marker.strip.tube = true;
  for (Shape& shape : marker.shapes) shape.rotations = {{0}, {180}};
  for (const std::size_t k : {0, 1}) marker.pieces[k].rules.on_fold = true;
  marker.pieces[1].orientation.rotation = {180};
  const Marker tight = compacted(marker);
  EXPECT_EQ(tight.pieces[0].at.y, 0);
  EXPECT_EQ(tight.pieces[1].at.y, 250'000);
  EXPECT_LT(length_of(tight), length_of(marker) / 2);
  SumCache sums;
  const auto dragged = dragging::drag(tight, PieceId{1}, {600'000, 100'000}, dragging::DragMode::kPlace, {sums});
  EXPECT_EQ(dragged.marker.pieces[1].at.y, 250'000);
  // The diamond lies under the roof on the upper fold, and on the lower edge.
  Marker wedged = marker;
  wedged.pieces.erase(wedged.pieces.begin());
  wedged.pieces[0].at = {200'000, 250'000};
  wedged.pieces[1].at = {50'000, 0};
  ASSERT_TRUE(is_valid(wedged));
  const auto path = held(wedged);
  EXPECT_NEAR(worth_of(path, Rule::kFold, PieceId{0}), 1, 1e-6);
  EXPECT_EQ(path.rules.size(), 1U);
}

}  // namespace
}  // namespace selvage::motion
