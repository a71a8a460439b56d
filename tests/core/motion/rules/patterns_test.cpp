// Stripes, plaids and match sets in motions: pieces stay in their phase, and move by whole repeats.
#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/piece/bump.h"
#include "core/motion/placing/place.h"
#include "core/motion/separation/separate.h"
#include "core/search/refine.h"
#include "tests/core/motion/rules/ruled_markers.h"

namespace selvage::motion {
namespace {

using namespace test_rules;

// Three squares in a row with gaps, the middle one on stripes 70,000 apart that begin at x = 0.
Marker striped() {
  Marker marker = squares({{20'000, 0}, {210'000, 0}, {400'000, 0}});
  marker.strip.repeat.along = 70'000;
  marker.pieces[1].rules.match = Vec{0, 0};
  return marker;
}

TEST(Rules, CompactionKeepsARepeatAndReportsItsPrice) {
  Marker narrow = striped();
  narrow.strip.width = kSide;
  narrow.pieces[1].at.x = 140'000;  // the gap before it is too short for a square
  SumCache sums;
  auto done = compact(narrow, compaction::compaction_settings(compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->marker.pieces[0].at.x, 0);
  EXPECT_EQ(done->marker.pieces[1].at.x, 140'000);
  EXPECT_EQ(done->length_after, 340'000);
  const auto path = held(done->marker);
  EXPECT_NEAR(worth_of(path, Rule::kMatchX, PieceId{1}), 1, 1e-6);
}

TEST(Rules, RefinementTriesOtherRepeats) {
  SumCache sums;
  auto settings = search::refine_settings();
  settings.effort = settings.least_effort = 2'000;
  const auto done = search::refine(striped(), settings, {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_LE(done->length_after, 340'000);  // the middle one has moved to 140,000, or lies beside the others
}

TEST(Rules, ADragSnapsToTheNearestRepeatWithRoom) {
  const Marker marker = striped();
  SumCache sums;
  for (const auto mode : {dragging::DragMode::kPlace, dragging::DragMode::kPush}) {
    const auto dragged = [&](Vec to) { return dragging::drag(marker, PieceId{1}, to, mode, {sums}).marker; };
    EXPECT_EQ(dragged({600'000, 700'000}).pieces[1].at, (Vec{560'000, 700'000}));
    EXPECT_EQ(dragged({240'000, 0}).pieces[1].at.x, 210'000);
    EXPECT_EQ(dragged({150'000, 10'000}).pieces[1].at, (Vec{140'000, 10'000}));
    const Marker beside = dragged({80'000, 10'000});  // at 70,000 it lies above or beside the first square
    EXPECT_TRUE(is_valid(beside));
    EXPECT_EQ(beside.pieces[1].at.x % 70'000, 0);
  }
}

TEST(Rules, APieceOnAPlaidIsPlacedOnItsCrossings) {
  Marker marker = striped();
  marker.strip.repeat.across = 90'000;
  SumCache sums;
  const auto placed = placing::repair_and_place(marker, PieceId{1}, {30'000, 50'000}, {}, {sums});
  ASSERT_TRUE(placed);
  ASSERT_TRUE(placed->place);
  EXPECT_EQ(placed->place->at, (Vec{140'000, 90'000}));  // on nearer crossings it would lie on the first square
  EXPECT_TRUE(is_valid(placed->marker));
}

TEST(Rules, RepairPutsAPieceBackOnItsStripe) {
  Marker marker = striped();
  marker.pieces[1].at.x += 15;
  EXPECT_FALSE(is_valid(marker));
  const Marker tight = compacted(marker);
  EXPECT_EQ(tight.pieces[1].at.x % 70'000, 0);
}

// Three squares of which the outer two are a match set on stripes 70,000 apart: their repeats lie at any phase.
Marker matched_pair() {
  Marker marker = squares({{20'000, 0}, {210'000, 0}, {370'000, 0}});
  marker.strip.repeat = {.along = 70'000, .phase = {1'234, 0}};
  for (const std::size_t piece : {0, 2}) {
    marker.pieces[piece].rules.match = Vec{0, 0};
    marker.pieces[piece].rules.match_set = "A";
  }
  return marker;
}

TEST(Rules, AMatchSetMovesAsOneAlongTheRepeat) {
  Marker narrow = matched_pair();
  narrow.strip.width = kSide;
  SumCache sums;
  auto done = compact(narrow, compaction::compaction_settings(compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->marker.pieces[0].at.x, 0);  // by 20,000, to no repeat of the cloth
  EXPECT_EQ(done->marker.pieces[2].at.x, 350'000);
  const auto path = held(done->marker);
  EXPECT_NEAR(worth_of(path, Rule::kMatchX, PieceId{0}), 1, 1e-6);
  EXPECT_NEAR(worth_of(path, Rule::kMatchX, PieceId{2}), 1, 1e-6);
}

TEST(Rules, APieceOfAMatchSetMovesAcrossTheStripesAlone) {
  SumCache sums;
  const auto bumped = piece::repair_and_bump(matched_pair(), PieceId{2}, 0, 1, {sums});
  ASSERT_TRUE(bumped);
  EXPECT_EQ(bumped->marker.pieces[2].at, (Vec{370'000, 900'000}));
  EXPECT_EQ(bumped->marker.pieces[0].at, (Vec{20'000, 0}));
  EXPECT_TRUE(is_valid(bumped->marker));
}

TEST(Rules, ADragTakesAPieceOfAMatchSetByWholeRepeats) {
  const Marker marker = matched_pair();
  SumCache sums;
  for (const auto mode : {dragging::DragMode::kPlace, dragging::DragMode::kPush}) {
    const auto dragged = [&](Vec to) { return dragging::drag(marker, PieceId{2}, to, mode, {sums}).marker; };
    EXPECT_EQ(dragged({600'000, 700'000}).pieces[2].at, (Vec{580'000, 700'000}));
    EXPECT_EQ(dragged({600'000, 700'000}).pieces[0].at, (Vec{20'000, 0}));
  }
}

TEST(Rules, RepairAndSeparationBringAMatchSetIntoPhase) {
  Marker near = matched_pair();
  near.pieces[2].at.x += 15;
  EXPECT_FALSE(is_valid(near));
  EXPECT_TRUE(is_valid(compacted(near)));
  Marker far = matched_pair();
  far.pieces[2].at.x += 20'000;
  SumCache sums;
  const auto refused = compact(far, compaction::compaction_settings(compaction::Accuracy::kDraft), {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kOutsideStrip);
  const auto separated = separation::separate(far, {}, {sums});
  ASSERT_TRUE(separated) << separated.error().message;
  EXPECT_TRUE(is_valid(separated->marker));
  EXPECT_EQ(separated->marker.pieces[2].at.x - separated->marker.pieces[0].at.x, 350'000);
}

TEST(Rules, SeparationMovesPiecesOfAMatchSetByWholeRepeatsOnAPlaid) {
  // On both axes the two share their displacement in linear programs: only a leap takes them off each other.
  for (const bool in_set : {true, false}) {
    Marker marker = squares({{140'000, 90'000}, {140'000, 120'000}});
    marker.strip.repeat = {70'000, 30'000, {}};
    for (Piece& piece : marker.pieces) {
      piece.rules.match = Vec{0, 0};
      if (in_set) piece.rules.match_set = "A";
    }
    ASSERT_FALSE(is_valid(marker));
    SumCache sums;
    const auto separated = separation::separate(marker, {.grow = 1}, {sums});
    ASSERT_TRUE(separated) << separated.error().message;
    EXPECT_TRUE(separated->apart) << in_set;
    EXPECT_TRUE(is_valid(separated->marker)) << in_set;
  }
}

TEST(Rules, SeparationKeepsAMatchSetInTheStrip) {  // the nearest place in phase is below the selvedge
  Marker marker = squares({{20'000, 420'000}, {210'000, 600'000}, {370'000, 250'000}});
  marker.strip.below = 300'000;
  marker.strip.repeat = {.across = 200'000};
  for (const std::size_t piece : {0, 2}) {
    marker.pieces[piece].rules.match = Vec{0, 0};
    marker.pieces[piece].rules.match_set = "A";
  }
  SumCache sums;
  const auto separated = separation::separate(marker, {}, {sums});
  ASSERT_TRUE(separated) << separated.error().message;
  EXPECT_TRUE(separated->apart);
  EXPECT_TRUE(is_valid(separated->marker));
}

TEST(Rules, SeparationPutsAPieceOnTheStripeWithinTheMarker) {  // the nearest one is beyond its end
  Marker marker = squares({{40'000, 0}});
  marker.strip.repeat.along = 70'000;
  marker.pieces[0].rules.match = Vec{0, 0};
  SumCache sums;
  const auto done = separation::separate(marker, {}, {sums});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->marker.pieces[0].at, (Vec{0, 0}));
  EXPECT_TRUE(is_valid(done->marker));
}

TEST(Rules, AMatchSetWithALockedPieceStaysInItsPhase) {
  Marker marker = matched_pair();
  marker.pieces[0].locked = true;
  const Marker tight = compacted(marker);
  EXPECT_EQ(tight.pieces[0].at, (Vec{20'000, 0}));
  EXPECT_EQ((tight.pieces[2].at.x - 20'000) % 70'000, 0);
}

TEST(Rules, APieceAloneInItsMatchSetIsFree) {
  Marker marker = matched_pair();
  marker.pieces[2].rules.match_set = "B";
  marker.strip.width = kSide;
  SumCache sums;
  auto done = compact(marker, compaction::compaction_settings(compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->length_after, 3 * kSide);
}

}  // namespace
}  // namespace selvage::motion
