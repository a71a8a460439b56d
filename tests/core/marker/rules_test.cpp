// Cloth's rules: the rooms that they leave, the proof that they are kept, and what make_marker refuses.
#include "core/marker/rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "core/marker/clearance.h"
#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "tests/core/marker/squares.h"
#include "tests/core/marker/verdicts.h"

namespace selvage::test {
namespace {

// Squares of side 10 in a strip 100 wide.
TEST(Rooms, WithoutRulesAreThoseOfTheStrip) {
  const Marker marker = squares({{0, 0}, {50, 90}});
  EXPECT_FALSE(marker::rooms_of(marker));
  EXPECT_EQ(marker::PlacedPieces{marker}.room(1, marker.strip, 60), (Box{{0, 0}, {60, 100}}));
}

TEST(Rooms, TheStripsSelvedgesReplaceItsMargin) {
  Marker marker = squares({{2, 7}, {50, 88}});
  marker.strip.margin = 2;
  marker.strip.below = 7;
  EXPECT_EQ(marker.strip.room(60), (Box{{2, 7}, {60, 98}}));
  EXPECT_TRUE(is_kept(marker));
  marker.strip.above = 3;
  EXPECT_FALSE(is_kept(marker));
  EXPECT_EQ(marker::protrusion_of(marker::PlacedPieces{marker}, 1, marker.strip), 1);
}

TEST(Rooms, APiecesSelvedgesReplaceTheStrips) {
  Marker marker = squares({{2, 0}, {50, 80}});
  marker.strip.margin = 2;
  EXPECT_FALSE(is_kept(marker));
  marker.pieces[0].rules.below = 0;
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[1].rules.above = 10;
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[1].rules.above = 11;
  EXPECT_FALSE(is_kept(marker));
}

TEST(Rooms, ABandHoldsAPieceBetweenItsEnds) {
  Marker marker = squares({{20, 0}, {50, 0}});
  marker.pieces[0].rules.from = 20;
  marker.pieces[0].rules.to = 30;
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[0].at.x = 19;
  EXPECT_FALSE(is_kept(marker));
  marker.pieces[0].at.x = 21;
  EXPECT_FALSE(is_kept(marker));
}

TEST(Rooms, APieceOnTheFoldLiesOnTheLowerEdgeWhateverTheSelvedge) {
  Marker marker = squares({{5, 0}});
  marker.strip.margin = 5;
  marker.pieces[0].rules.on_fold = true;
  EXPECT_TRUE(is_kept(marker));
  for (const Coord y : {-1, 1}) {
    marker.pieces[0].at.y = y;
    EXPECT_FALSE(is_kept(marker)) << y;
  }
}

TEST(Rooms, PiecesOfAShadeLieWithinItsLength) {
  Marker marker = squares({{0, 0}, {40, 0}, {20, 20}, {90, 0}});
  marker.shade = 50;
  for (const int piece : {0, 1, 2}) marker.pieces[static_cast<std::size_t>(piece)].rules.shade = "A";
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[1].at.x = 41;
  EXPECT_FALSE(is_kept(marker));
  const marker::PlacedPieces pieces{marker};
  ASSERT_EQ(pieces.shades().size(), 1U);
  EXPECT_EQ(pieces.excess_of(pieces.shades()[0]), 1);
  marker.shade.reset();
  EXPECT_TRUE(is_kept(marker));
}

TEST(Rooms, APieceMayLieWhereverItsShadeIsNotTooLong) {
  Marker marker = squares({{30, 0}, {40, 20}, {60, 40}});
  marker.shade = 50;
  for (Piece& piece : marker.pieces) piece.rules.shade = "A";
  const marker::PlacedPieces pieces{marker};
  EXPECT_EQ(pieces.room_among(0, {true, false, false}, marker.strip, 1000), (Box{{20, 0}, {90, 100}}));
  EXPECT_EQ(pieces.room_among(0, {true, false, true}, marker.strip, 1000), (Box{{0, 0}, {90, 100}}));
}

TEST(Rooms, APieceIsNoLongerThanTheShadeOfAnUnplacedOne) {
  Marker marker = squares({{0, 0}, {70, 0}});
  marker.shade = 9;
  for (Piece& piece : marker.pieces) piece.rules.shade = "A";
  marker.pieces.pop_back();
  EXPECT_TRUE(is_valid(marker));
  marker.unplaced = {marker.pieces[0]};
  marker.unplaced[0].id = "later";
  EXPECT_FALSE(is_valid(marker));
  EXPECT_FALSE(make_marker(marker));
}

TEST(Rooms, ChecksNameTheShadeThatIsTooLong) {
  Marker marker = squares({{0, 0}, {70, 0}, {20, 20}});
  marker.shade = 50;
  for (Piece& piece : marker.pieces) piece.rules.shade = "A";
  SumCache sums;
  const marker::Validity validity = marker::check(marker, sums);
  EXPECT_FALSE(validity.valid());
  ASSERT_EQ(validity.shades.size(), 1U);
  EXPECT_EQ(validity.shades[0].leftmost, PieceId{0});
  EXPECT_EQ(validity.shades[0].rightmost, PieceId{1});
  EXPECT_EQ(validity.shades[0].by, 30);
  EXPECT_FALSE(is_valid(marker));
}

// What is proved again after an edit: a stricter rule also concerns pieces that did not move.
TEST(Rooms, FiguresAfterAnEditRespectStricterRules) {
  Marker before = squares({{0, 0}, {40, 0}});
  before.overlap = 3;
  before.shade = 50;
  for (Piece& piece : before.pieces) piece.rules.shade = "A";
  const marker::PlacedPieces pieces{before};
  const auto valid_after = [&](const Marker& after) {
    return figures_after(before, pieces, figures_of(before), after).valid;
  };
  EXPECT_TRUE(valid_after(before));
  Marker after = before;
  after.shade = 49;
  EXPECT_FALSE(valid_after(after));
  after = before;
  after.pieces[0].rules.from = 1;
  EXPECT_FALSE(valid_after(after));
  after = before;
  after.strip.below = 1;
  EXPECT_FALSE(valid_after(after));
}

TEST(Rooms, FiguresAfterAnEditRespectASmallerOverlapAllowance) {
  Marker before = squares({{0, 0}, {8, 0}});
  before.overlap = 2;
  const marker::PlacedPieces pieces{before};
  ASSERT_TRUE(figures_after(before, pieces, figures_of(before), before).valid);
  Marker after = before;
  after.overlap = 1;
  EXPECT_FALSE(figures_after(before, pieces, figures_of(before), after).valid);
  after = before;
  after.pieces[0].overlap = 1;
  EXPECT_FALSE(figures_after(before, pieces, figures_of(before), after).valid);
}

TEST(Rooms, RulesThatNoPositionKeepsAreRefused) {
  const Marker good = squares({{20, 0}, {50, 0}});
  ASSERT_EQ(blamed(good), "");
  const auto with = [&good](auto change) {
    Marker marker = good;
    change(marker, marker.pieces[0].rules);
    return blamed(marker);
  };
  EXPECT_EQ(with([](Marker& m, marker::Rules&) { m.strip.below = -1; }), "/strip/below");
  EXPECT_EQ(with([](Marker& m, marker::Rules&) { m.strip.above = 100; }), "/strip/above");
  EXPECT_EQ(with([](Marker& m, marker::Rules&) { m.strip.above = m.strip.below = 50; }), "/strip/above");
  EXPECT_EQ(with([](Marker& m, marker::Rules&) { m.shade = 0; }), "/shade");
  EXPECT_EQ(with([](Marker& m, marker::Rules& r) { m.shade = 9, r.shade = "A"; }), "") << "alone in its shade";
  EXPECT_EQ(with([](Marker& m, marker::Rules& r) { m.shade = 9, r.shade = m.pieces[1].rules.shade = "A"; }), "/shade");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.below = -1; }), "/pieces/0/rules/below");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.below = 50, r.above = 41; }), "/pieces/0/rules");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.below = 50, r.above = 40; }), "");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.from = -1; }), "/pieces/0/rules/from");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.from = 20, r.to = 20; }), "/pieces/0/rules/to");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.from = 20, r.to = 29; }), "/pieces/0/rules/to");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.from = 20, r.to = 30; }), "");
  EXPECT_EQ(with([](Marker&, marker::Rules& r) { r.on_fold = true, r.below = 0; }), "/pieces/0/rules/below");
  EXPECT_EQ(with([](Marker& m, marker::Rules& r) {
              m.shapes[0].outline = {{0, 0}, {10, 5}, {0, 10}, {-10, 5}};
              r.on_fold = true;
            }),
            "/pieces/0/rules/fold");
}

TEST(Rooms, APieceTooTallForTheMarginsMayHaveSelvedgesOfItsOwn) {
  Marker marker = squares({{20, 0}});
  marker.shapes[0].outline = {{0, 0}, {10, 0}, {10, 96}, {0, 96}};
  marker.strip.margin = 5;
  EXPECT_EQ(blamed(marker), "/pieces/0");
  marker.pieces[0].rules.below = 0;
  marker.pieces[0].rules.above = 4;
  EXPECT_EQ(blamed(marker), "");
  marker.pieces[0].rules = {.on_fold = true};
  EXPECT_EQ(blamed(marker), "/pieces/0/rules");
}

// Squares of side 10 whose lower left corners are their match points, on stripes 7 apart that begin at x = 3.
TEST(Rooms, AMatchedPieceStaysInItsRepeat) {
  Marker marker = squares({{24, 5}, {50, 90}});
  marker.strip.repeat = {.along = 7, .phase = {3, 0}};
  marker.pieces[0].rules.match = Vec{0, 0};
  EXPECT_TRUE(is_kept(marker));
  const auto low_at = [&](Coord x) {
    marker.pieces[0].at.x = x;
    return marker::PlacedPieces{marker}.room(0, marker.strip, 60).low.x;
  };
  EXPECT_EQ(low_at(24), 24);
  EXPECT_EQ(low_at(27), 24);
  EXPECT_EQ(low_at(28), 31);
  EXPECT_EQ(low_at(-40), 3);   // the first repeat in the strip
  EXPECT_EQ(low_at(400), 45);  // and the last
  EXPECT_FALSE(is_kept(marker));
  marker.pieces[0].at = {28, 5};
  EXPECT_EQ(marker::protrusion_of(marker::PlacedPieces{marker}, 0, marker.strip), 3);
}

TEST(Rooms, PhaseErrorIsTheDistanceToTheNearestRepeat) {
  const marker::Repeat stripes{.along = 7};
  for (const auto& [way, off] : {std::pair{0, 0}, {7, 0}, {-14, 0}, {8, 1}, {10, 3}, {11, -3}, {-1, -1}, {-4, 3}})
    EXPECT_EQ(off_repeat({way, 5}, stripes), (Vec{off, 0})) << way;
}

// Squares of side 10 on stripes 7 apart, which begin somewhere else.
TEST(Rooms, APieceOfAMatchSetIsInPhaseWithTheOthers) {
  Marker marker = squares({{24, 5}, {45, 90}, {60, 50}});
  marker.strip.repeat = {.along = 7, .phase = {2, 0}};
  for (Piece& piece : marker.pieces) piece.rules = {.match = Vec{0, 0}, .match_set = "A"};
  marker.pieces[2].rules.match_set = "B";  // alone
  EXPECT_TRUE(is_kept(marker));
  const marker::PlacedPieces pieces{marker};
  ASSERT_EQ(pieces.match_sets().size(), 1U);
  EXPECT_EQ(pieces.match_sets()[0], (marker::MatchSet{0, 1}));
  EXPECT_EQ(pieces.room(0, marker.strip, 60), marker.strip.room(60));
  EXPECT_EQ(pieces.repeat_of(2, marker.strip), Vec{});
  EXPECT_EQ(pieces.room_among(0, {true, false, false}, marker.strip, 60).low.x, 24);
  EXPECT_EQ(pieces.room_among(0, {true, true, false}, marker.strip, 60), marker.strip.room(60));
  marker.pieces[1].at.x = 47;
  EXPECT_FALSE(is_kept(marker));
  SumCache sums;
  const auto validity = marker::check(marker, sums);
  ASSERT_EQ(validity.matches.size(), 1U);
  EXPECT_EQ(validity.matches[0].piece, PieceId{1});
  EXPECT_EQ(validity.matches[0].by, (Vec{2, 0}));
  marker.pieces[1].rules.match.reset();
  EXPECT_EQ(blamed(marker), "/pieces/1/rules/matchSet");
}

TEST(Rooms, TheMatchPointTurnsWithThePiece) {
  Marker marker = squares({{24, 5}, {50, 90}});
  marker.shapes[0].rotations = {{0}, {90}, {180}};
  marker.strip.repeat = {.along = 7, .across = 5};
  marker.pieces[0].rules.match = Vec{4, 0};
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[0].orientation.rotation = Angle::of_degrees(180);
  marker.pieces[0].at = {25, 15};
  EXPECT_EQ(turned_match(marker.pieces[0]), (Vec{-4, 0}));
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[0].orientation.rotation = Angle::of_degrees(90);
  marker.pieces[0].at = {35, 16};
  EXPECT_EQ(turned_match(marker.pieces[0]), (Vec{0, 4}));
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[0].at.y = 17;
  EXPECT_FALSE(is_kept(marker));
}

TEST(Rooms, APatternThatLeavesAPieceNoPositionIsRefused) {
  Marker marker = squares({{0, 0}, {50, 90}});
  marker.strip.repeat = {.across = 95, .phase = {0, 1}};
  marker.pieces[0].rules.match = Vec{0, 0};
  EXPECT_EQ(blamed(marker), "");
  marker.strip.below = 2;
  EXPECT_EQ(blamed(marker), "/pieces/0/rules/match");
  marker.strip.repeat.across = -1;
  EXPECT_EQ(blamed(marker), "/strip/repeat/across");
}

TEST(Rooms, APieceLiesWithItsNap) {
  Marker marker = squares({{20, 20}, {50, 50}});
  marker.shapes[0].rotations = {{0}, {90}, {180}, {270}};
  const auto lies = [&marker](double degrees, marker::Nap nap) {
    marker.pieces[0].orientation.rotation = Angle::of_degrees(degrees);
    marker.pieces[0].rules.nap = nap;
    EXPECT_EQ(may_lie(marker, marker.pieces[0]), blamed(marker).empty());
    return blamed(marker).empty();
  };
  using marker::Nap;
  for (const auto& [degrees, up, down] :
       {std::tuple{0.0, true, false}, {180.0, false, true}, {90.0, false, false}, {270.0, false, false}}) {
    EXPECT_EQ(lies(degrees, Nap::kUp), up) << degrees;
    EXPECT_EQ(lies(degrees, Nap::kDown), down) << degrees;
  }
  EXPECT_EQ(blamed(marker), "/pieces/0/rules/nap");
  marker.pieces[0].orientation.flip = marker.shapes[0].may_flip = true;  // a flip does not turn the nap
  EXPECT_TRUE(lies(0, Nap::kUp));
  marker.shapes[0].rotations = {{0}};
  EXPECT_FALSE(lies(0, Nap::kDown)) << "no rotation that the shape allows";
}

// A roof with a straight side below, on a tube 100 wide.
Marker roof_on_tube(double degrees, Vec at) {
  Marker marker = squares({at});
  marker.shapes[0].outline = {{0, 0}, {20, 0}, {10, 15}};
  marker.shapes[0].rotations = {{0}, {90}, {180}};
  marker.pieces[0].orientation.rotation = {degrees};
  marker.pieces[0].rules.on_fold = true;
  marker.strip.tube = true;
  return marker;
}

TEST(Tubes, APieceLiesOnTheFoldThatItsStraightSideFaces) {
  EXPECT_TRUE(is_kept(roof_on_tube(0, {5, 0})));
  EXPECT_FALSE(is_kept(roof_on_tube(0, {5, 85})));
  EXPECT_TRUE(is_kept(roof_on_tube(180, {25, 100})));
  EXPECT_FALSE(is_kept(roof_on_tube(180, {25, 99})));
  EXPECT_EQ(blamed(roof_on_tube(180, {25, 100})), "");
  EXPECT_EQ(blamed(roof_on_tube(90, {40, 0})), "/pieces/0/rules/fold") << "its straight side faces neither";
  Marker folded = roof_on_tube(180, {25, 100});
  folded.strip.tube = false;
  EXPECT_EQ(blamed(folded), "/pieces/0/rules/fold");
  folded.shapes[folded.pieces[0].shape.value].rotations = {{180}};
  folded.unplaced = std::move(folded.pieces);
  folded.pieces.clear();
  EXPECT_EQ(blamed(folded), "/unplaced/0/rules/fold");
}

// Turning the outline for each piece would take a minute: 5,000 pieces, 720 orientations, 499 corners.
TEST(Rooms, TheSideOfAShapeForTheFoldIsLookedForOnce) {
  Shape half_star{.id = "half star", .outline = {}, .rotations = {}, .may_flip = true, .tilt_limit = {}};
  for (int k = 0; k < 499; ++k) {  // its one long side lies below
    const double angle = std::numbers::pi * k / 498, radius = k % 2 == 0 ? 1e6 : 5e5;
    half_star.outline.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  for (int k = 0; k < 360; ++k) half_star.rotations.push_back({0.7 + k});
  Marker marker = squares({{0, 0}});
  marker.shapes.push_back(half_star);
  marker.shapes.push_back(half_star);
  marker.shapes[2].id = "other half star";
  marker.shapes[1].rotations.push_back({0});
  for (int k = 0; k < 5'000; ++k) {
    marker.unplaced.push_back({.id = "f" + std::to_string(k), .shape = {1}, .orientation = {}, .at = {}});
    marker.unplaced.back().rules.on_fold = true;
  }
  EXPECT_EQ(blamed(marker), "");
  marker.unplaced[2].shape = {2};  // has no side in any of its orientations
  EXPECT_EQ(blamed(marker), "/unplaced/2/rules/fold");
}

TEST(Tubes, AFoldHasNoSelvedgeOnEitherSide) {
  Marker marker = roof_on_tube(180, {25, 100});
  marker.strip.above = marker.strip.below = 10;
  EXPECT_TRUE(is_kept(marker));
  marker.pieces[0].rules.on_fold = false;
  EXPECT_FALSE(is_kept(marker)) << "the other pieces lie as on any strip";
  marker.pieces[0].rules.on_fold = true;
  marker.pieces[0].rules.above = 5;
  EXPECT_EQ(blamed(marker), "/pieces/0/rules/above");
}

}  // namespace
}  // namespace selvage::test
