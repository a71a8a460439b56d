// Zones of the strip: what may cover them, and what make_marker refuses.
#include <gtest/gtest.h>

#include "core/marker/clearance.h"
#include "core/marker/figures.h"
#include "core/marker/rules.h"
#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "tests/core/marker/squares.h"
#include "tests/core/marker/verdicts.h"

namespace selvage::test {
namespace {

// A square, a zone that it touches, and a zone over the latter that reaches beyond the strip.
Marker with_zones() {
  Marker marker = squares({{20, 0}, {30, 5}, {35, -4}});
  marker.pieces[1].rules.zone = marker.pieces[2].rules.zone = true;
  return *make_marker(std::move(marker));
}

TEST(Zones, AreNotCountedAsPiecesNorInLengthAndUtilisation) {
  const Marker marker = with_zones();
  EXPECT_EQ(piece_count(marker), 1U);
  EXPECT_EQ(length_of(marker), 30);
  EXPECT_EQ(marker::PlacedPieces{marker}.length(), 30);
  EXPECT_DOUBLE_EQ(utilisation_of(marker), 100.0 / 3000);
  EXPECT_TRUE(marker.pieces[1].locked) << "a zone stays where it is";
}

TEST(Zones, MayLieAnywhereAndOverEachOtherButUnderNoPiece) {
  Marker marker = with_zones();
  EXPECT_TRUE(is_valid(marker));
  marker.pieces[0].at.x = 21;
  SumCache sums;
  const marker::Validity validity = marker::check(marker, sums);
  ASSERT_EQ(validity.overlaps.size(), 1U);
  EXPECT_EQ(validity.overlaps[0].second, PieceId{1});
  EXPECT_NEAR(validity.overlaps[0].depth, 1, 1e-9);
  EXPECT_TRUE(validity.protrusions.empty());
  marker.pieces[1].at = {31, 0};
  EXPECT_TRUE(is_valid(marker));
}

TEST(Zones, NeedNoSpacingAndAllowNoOverlap) {
  Marker marker = with_zones();
  marker.spacing = 3;
  marker.pieces[0].buffer = 4;
  EXPECT_TRUE(is_valid(marker));
  marker.spacing = marker.pieces[0].buffer = 0;
  marker.overlap = 2;
  EXPECT_TRUE(is_valid(marker));
  marker.pieces[0].at.x = 21;
  EXPECT_FALSE(is_valid(marker));
}

TEST(Zones, FiguresAfterAnEditRespectZonesThatAreNewOrHaveMoved) {
  const Marker before = with_zones();
  const marker::PlacedPieces pieces{before};
  const auto valid_after = [&](const Marker& after) {
    return figures_after(before, pieces, figures_of(before), after).valid;
  };
  Marker after = before;
  after.pieces[1].at.x = 29;
  EXPECT_FALSE(valid_after(after));
  after.pieces[1].at.x = 40;
  EXPECT_TRUE(valid_after(after));
  after = before;
  after.pieces[1].rules.zone = false;  // now a piece, which the other zone covers
  EXPECT_FALSE(valid_after(after));
}

TEST(Zones, RefuseOtherPropertiesOfPieces) {
  const auto with = [](auto change) {
    Marker marker = with_zones();
    change(marker.pieces[1]);
    return blamed(marker);
  };
  EXPECT_EQ(with([](Piece&) {}), "");
  EXPECT_EQ(with([](Piece& zone) { zone.rules.below = 0; }), "/pieces/1/rules/zone");
  EXPECT_EQ(with([](Piece& zone) { zone.group = "g"; }), "/pieces/1/rules/zone");
  EXPECT_EQ(with([](Piece& zone) { zone.buffer = 1; }), "/pieces/1/rules/zone");
  EXPECT_EQ(with([](Piece& zone) { zone.overlap = 0; }), "/pieces/1/rules/zone");
  EXPECT_EQ(with([](Piece& zone) { zone.locked = {}; }), "");
  Marker waiting = with_zones();
  waiting.unplaced.push_back(waiting.pieces.back());
  waiting.pieces.pop_back();
  EXPECT_EQ(blamed(waiting), "/unplaced/0/rules/zone");
  Marker nothing_else = with_zones();
  nothing_else.pieces.erase(nothing_else.pieces.begin());
  EXPECT_EQ(blamed(nothing_else), "/pieces");
}

// Also compares the check of all distances with the proof.
bool is_valid_by_all_checks(const Marker& marker) {
  const Marker made = *make_marker(marker);
  SumCache sums;
  EXPECT_EQ(marker::check(made, sums).valid(), is_valid(made));
  return is_valid(made);
}

TEST(Zones, WithAQualityMayBeCoveredByPiecesThatAcceptIt) {
  Marker marker = with_zones();
  marker.pieces[0].at.x = 25;
  const auto valid = [&marker](std::optional<marker::Quality> zone, std::optional<marker::Quality> piece) {
    marker.pieces[0].rules.quality = piece;
    marker.pieces[1].rules.quality = zone;
    return is_valid_by_all_checks(marker);
  };
  EXPECT_TRUE(valid(2, 2));
  EXPECT_TRUE(valid(1, 2));
  EXPECT_FALSE(valid(3, 2));
  EXPECT_FALSE(valid(1, std::nullopt)) << "a piece accepts only the best cloth unless it says more";
  EXPECT_FALSE(valid(std::nullopt, marker::kWorstQuality)) << "no piece accepts a zone without a quality";
}

TEST(Zones, OfEachAcceptedQualityMayBeCovered) {
  Marker marker = with_zones();
  marker.pieces[0].at.x = 30;  // on both zones
  marker.pieces[0].rules.quality = 1;
  marker.pieces[1].rules.quality = 1;
  marker.pieces[2].rules.quality = 2;
  EXPECT_FALSE(is_valid(marker));
  EXPECT_EQ(marker::conflicts(marker::PlacedPieces{marker}), (std::vector<marker::PiecePair>{{0, 2}}));
  marker.pieces[0].rules.quality = 2;
  EXPECT_TRUE(is_valid(marker));
}

// The square's right half is seen, and accepts no worse cloth than class 1; the rest accepts 2.
Marker with_part() {
  Marker marker = with_zones();
  marker.pieces[0].rules.quality = 2;
  marker.pieces[0].rules.part = marker::Part{{{5, 0}, {10, 0}, {10, 10}, {5, 10}}, 1};
  marker.pieces[1].rules.quality = 2;
  return marker;
}

TEST(Zones, LieUnderAPieceButNotUnderItsPart) {
  const auto valid = [](Coord x, marker::Quality quality, bool flip = false) {
    Marker marker = with_part();
    marker.shapes[0].may_flip = true;
    marker.shapes[0].rotations = {{0}, {180}};
    marker.pieces[0].at = {x, 0};
    if (flip) marker.pieces[0].orientation = {true, {180}, {}};
    marker.pieces[1].rules.quality = quality;
    marker.pieces[2].at.x = 90;
    return is_valid_by_all_checks(marker);
  };
  // The zone begins at 30 and ends at 40.
  EXPECT_TRUE(valid(20, 2));
  EXPECT_FALSE(valid(21, 2));
  EXPECT_FALSE(valid(34, 2));
  EXPECT_TRUE(valid(35, 2)) << "only the left half lies on it";
  EXPECT_TRUE(valid(25, 1)) << "the part accepts it, too";
  EXPECT_FALSE(valid(35, 3)) << "nothing of the piece accepts it";
  EXPECT_TRUE(valid(35, 2, true)) << "turned and mirrored, its part is on the left";
  EXPECT_FALSE(valid(36, 2, true));
}

TEST(Zones, AreMeasuredToThePartThatTheyMeet) {
  Marker marker = with_part();
  marker.pieces[0].at.x = 22;
  marker.pieces[2].at.x = 90;
  SumCache sums;
  const marker::Validity validity = marker::check(*make_marker(marker), sums);
  ASSERT_EQ(validity.overlaps.size(), 1U);
  EXPECT_NEAR(validity.overlaps[0].depth, 2, 1e-9);
  EXPECT_GE(validity.overlaps[0].witness_x, 30);
  EXPECT_LE(validity.overlaps[0].witness_x, 32);
}

TEST(Zones, PartsLieWithinTheirPieceAndAcceptLess) {
  const auto with = [](const Polygon& outline, marker::Quality quality, std::uint32_t piece = 0) {
    Marker marker = with_part();
    marker.pieces[piece].rules.part = marker::Part{outline, quality};
    return blamed(marker);
  };
  const Polygon corner{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(with(corner, 0), "");
  EXPECT_EQ(with(corner, 2), "/pieces/0/rules/part/quality");
  EXPECT_EQ(with(corner, -1), "/pieces/0/rules/part/quality");
  EXPECT_EQ(with({{0, 0}, {4, 0}, {0, 11}}, 0), "/pieces/0/rules/part/outline");
  EXPECT_EQ(with({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 0), "/pieces/0/rules/part/outline");
  EXPECT_EQ(with({{0, 0}, {4, 0}}, 0), "/pieces/0/rules/part/outline");
  EXPECT_EQ(with(corner, 0, 1), "/pieces/1/rules/zone");
  Marker waiting = with_part();
  waiting.unplaced.push_back(waiting.pieces.front());
  waiting.unplaced.back().id = "waiting";
  waiting.unplaced.back().rules.part->quality = 2;
  EXPECT_EQ(blamed(waiting), "/unplaced/0/rules/part/quality");
  Marker clockwise = with_part();
  clockwise.pieces[0].rules.part->outline = {{0, 4}, {4, 0}, {0, 0}};
  EXPECT_GT(doubled_area(make_marker(clockwise)->pieces[0].rules.part->outline), 0);
}

TEST(Zones, MustHaveAQualityWorseThanTheRestOfTheCloth) {
  const auto with = [](std::uint32_t piece, marker::Quality quality) {
    Marker marker = with_zones();
    marker.pieces[piece].rules.quality = quality;
    return blamed(marker);
  };
  EXPECT_EQ(with(1, 1), "");
  EXPECT_EQ(with(1, 0), "/pieces/1/rules/quality");
  EXPECT_EQ(with(1, marker::kWorstQuality + 1), "/pieces/1/rules/quality");
  EXPECT_EQ(with(0, 0), "");
  EXPECT_EQ(with(0, -1), "/pieces/0/rules/quality");
}

TEST(Zones, MayBeWiderThanTheStrip) {
  Marker marker = squares({{20, 0}, {50, -30}});
  marker.shapes.push_back({.id = "end", .outline = {{0, 0}, {10, 0}, {10, 160}, {0, 160}}, .tilt_limit = {}});
  marker.pieces[1].shape = ShapeId{1};
  EXPECT_EQ(blamed(marker), "/pieces/1");
  marker.pieces[1].rules.zone = true;
  EXPECT_EQ(blamed(marker), "");
  EXPECT_TRUE(is_valid(*make_marker(marker)));
}

}  // namespace
}  // namespace selvage::test
