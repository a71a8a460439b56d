// Cloth's rules in exact packing and containment: layouts keep them, and proofs take them into account.
#include "core/marker/rules.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/packing/contain.h"
#include "core/packing/pack.h"
#include "core/packing/refitting/compact_exactly.h"
#include "core/packing/refitting/fill_gaps.h"
#include "tests/core/motion/markers.h"
#include "tests/core/packing/optimum.h"

namespace selvage::packing {
namespace {

using test::expect_optimum;
using test::packed;

// Squares of 10 mm in a strip of 20 mm.
Marker squares(std::size_t count) {
  test::Layout layout{20'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  for (std::size_t k = 0; k < count; ++k) layout.put(square, {static_cast<Coord>(k) * 12'000, 0});
  return layout.marker();
}

Verdict verdict_of(const Marker& marker, const std::vector<PieceId>& pieces, const Box& room) {
  SumCache sums;
  const Containment done = contain(marker, pieces, room, {}, {sums});
  if (done.verdict == Verdict::kFound) {
    EXPECT_TRUE(is_valid(done.marker));
  }
  return done.verdict;
}

TEST(RulesInPacking, SquaresOnTheFoldLieInARow) {
  Marker marker = squares(4);
  expect_optimum(marker, 20'000);
  for (std::size_t k = 0; k < 3; ++k) marker.pieces[k].rules.on_fold = true;
  expect_optimum(marker, 30'000);
}

TEST(RulesInPacking, AnUnplacedPieceIsTurnedAsItsRulesAsk) {
  test::Layout layout{50'000};
  const auto board = layout.shape_of(test::rectangle(40'000, 30'000));
  const auto triangle = layout.shape_of({{0, 0}, {30'000, 10'000}, {0, 20'000}});
  for (const std::vector<Angle>& rotations : {std::vector<Angle>{}, {{0}, {90}}}) {
    for (const auto shape : {board, triangle}) {
      Marker marker = layout.marker();
      for (Shape& one : marker.shapes) one.rotations = rotations;
      marker.unplaced = {{.id = "a", .shape = {shape}, .orientation = {false, {90}, {}}, .at = {}}};
      marker.unplaced[0].rules.nap = shape == board ? std::optional{marker::Nap::kUp} : std::nullopt;
      marker.unplaced[0].rules.on_fold = shape == triangle;
      if (shape == triangle) marker.unplaced[0].orientation.rotation = {0};
      SumCache sums;
      const Packing found = pack(marker, {}, {sums});
      ASSERT_TRUE(found.found);
      EXPECT_TRUE(is_valid(found.marker));
      EXPECT_TRUE(make_marker(found.marker));
      const Packing as_given = pack(marker, {.turns = false}, {sums});
      EXPECT_FALSE(as_given.found);
      EXPECT_EQ(as_given.marker.unplaced.size(), 1u);
    }
  }
}

TEST(RulesInPacking, AMatchedPieceMayChangeToAnotherRepeat) {
  Marker marker = squares(2);
  marker.strip.width = 10'000;
  marker.strip.repeat.along = 5'000;
  marker.pieces[1].at.x = 30'000;
  marker.pieces[1].rules.match = Vec{0, 0};
  expect_optimum(marker, 20'000);
  const Box behind{{10'000, 0}, {20'000, 10'000}};
  EXPECT_EQ(verdict_of(marker, {PieceId{1}}, behind), Verdict::kFound);
}

TEST(RulesInPacking, ABandMovesTheOptimum) {
  Marker marker = squares(4);
  marker.pieces[0].rules.from = 15'000;
  expect_optimum(marker, 25'000);
  marker.pieces[0].rules = {};
  marker.pieces[3].rules.to = 10'000;  // it has to exchange places with others
  expect_optimum(marker, 20'000);
}

TEST(RulesInPacking, ASelvedgeOfItsOwnIsUsed) {
  Marker marker = squares(2);
  marker.strip.below = 1'000;
  marker.pieces[0].at.y = marker.pieces[1].at.y = 1'000;
  expect_optimum(marker, 20'000);
  marker.pieces[0].rules.below = 0;
  expect_optimum(marker, 10'000);
}

TEST(RulesInPacking, TheBoundHoldsWhereAShadeDoes) {
  Marker marker = squares(6);
  marker.shade = 10'000;
  marker.pieces[0].rules.shade = marker.pieces[5].rules.shade = "A";
  const Packing packing = packed(marker);
  ASSERT_TRUE(packing.found);
  EXPECT_LE(packing.bound, 30'000);
}

TEST(RulesInPacking, ContainmentProvesThatRulesLeaveNoRoom) {
  Marker marker = squares(2);
  marker.pieces[0].at = {0, 0};
  const Box room{{0, 0}, {20'000, 20'000}};
  EXPECT_EQ(verdict_of(marker, {{1}}, room), Verdict::kFound);
  marker.pieces[1].rules.to = 12'000;
  EXPECT_EQ(verdict_of(marker, {{1}}, room), Verdict::kFound);
  marker.pieces[1].rules.on_fold = true;
  EXPECT_EQ(verdict_of(marker, {{1}}, room), Verdict::kImpossible);
}

TEST(RulesInPacking, APieceGoesNearEnoughToTheOthersOfItsShade) {
  Marker marker = squares(3);
  marker.pieces[0].at = {0, 0};
  marker.pieces[1].at = {0, 10'000};
  marker.shade = 25'000;
  marker.pieces[0].rules.shade = marker.pieces[2].rules.shade = "A";
  EXPECT_EQ(verdict_of(marker, {{2}}, {{5'000, 0}, {40'000, 20'000}}), Verdict::kFound);
  EXPECT_EQ(verdict_of(marker, {{2}}, {{16'000, 0}, {40'000, 20'000}}), Verdict::kImpossible);
}

// Two wedges fit into a square when one of them is turned round.
TEST(RulesInPacking, ANapForbidsTurns) {
  test::Layout layout{10'000};
  const auto wedge = layout.shape_of({{0, 0}, {10'000, 0}, {0, 10'000}});
  layout.put(wedge, {0, 0}).put(wedge, {12'000, 0});
  Marker marker = layout.marker();
  marker.shapes[0].rotations = {{0}, {180}};
  expect_optimum(marker, 10'000);
  for (Piece& piece : marker.pieces) piece.rules.nap = marker::Nap::kUp;
  expect_optimum(marker, 20'000);
}

// Four squares, and a zone as large as one of them in the lower left corner.
Marker with_zone() {
  Marker marker = squares(5);
  marker.pieces[0].rules.zone = true;
  return *make_marker(std::move(marker));
}

TEST(RulesInPacking, PiecesArePackedAroundAZone) {
  expect_optimum(with_zone(), 30'000);
  Marker marker = with_zone();
  marker.pieces[0].at.x = 20'000;  // behind the shortest layout
  expect_optimum(marker, 20'000);
}

TEST(RulesInPacking, AZoneMayReachBeyondTheRoom) {
  const Box room{{5'000, 0}, {25'000, 20'000}};
  EXPECT_EQ(verdict_of(with_zone(), {{0}, {1}}, room), Verdict::kFound);
}

TEST(RulesInPacking, APieceIsPackedOntoAZoneThatItAccepts) {
  Marker marker = with_zone();
  marker.pieces[0].rules.quality = 1;
  expect_optimum(marker, 30'000);
  marker.pieces[3].rules.quality = 1;
  expect_optimum(marker, 20'000);
  const Box room{{0, 0}, {20'000, 20'000}};
  marker.pieces[0].at = {5'000, 0};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}}, room), Verdict::kFound);
  marker.pieces[0].rules.quality = 2;
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}}, room), Verdict::kImpossible);
}

TEST(RulesInPacking, APieceIsPackedOntoAZoneWithAllButItsPart) {
  // The zone covers the left half of the lower left square.
  Marker marker = with_zone();
  marker.shapes.push_back({.id = "half", .outline = test::rectangle(5'000, 10'000), .tilt_limit = {}});
  marker.pieces[0].shape = {1};
  marker.pieces[0].rules.quality = 1;
  marker.pieces[1].rules.quality = 1;
  marker.pieces[1].rules.part = marker::Part{{{5'000, 0}, {10'000, 0}, {10'000, 10'000}, {5'000, 10'000}}, 0};
  marker = *make_marker(std::move(marker));
  expect_optimum(marker, 20'000);
  const Box room{{0, 0}, {20'000, 20'000}};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}, {4}}, room), Verdict::kFound);
  marker.pieces[1].rules.part->outline = {{0, 0}, {5'000, 0}, {5'000, 10'000}, {0, 10'000}};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}, {4}}, room), Verdict::kImpossible);
  expect_optimum(marker, 25'000);
  // Turned by 180 degrees the part lies on the other side, although the outline is the same.
  marker.shapes[0].rotations = {{0}, {180}};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}, {4}}, room), Verdict::kFound);
}

TEST(RulesInPacking, OnATubeBothFoldsAreUsed) {
  test::Layout layout{20'000};
  const auto roof = layout.shape_of({{0, 0}, {10'000, 0}, {5'000, 10'000}});
  for (Coord k = 0; k < 2; ++k) layout.put(roof, {k * 12'000, 0});
  Marker marker = layout.marker();
  marker.shapes[0].rotations = {{0}, {180}};
  for (Piece& piece : marker.pieces) piece.rules.on_fold = true;
  EXPECT_GE(packed(marker).length_after, 20'000);
  marker.strip.tube = true;
  expect_optimum(marker, 10'000);
}

TEST(RulesInPacking, ContainmentProvesThatAZoneLeavesNoRoom) {
  Marker marker = with_zone();
  const Box room{{0, 0}, {20'000, 20'000}};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}}, room), Verdict::kFound);
  marker.pieces[0].at = {5'000, 0};
  EXPECT_EQ(verdict_of(marker, {{1}, {2}, {3}}, room), Verdict::kImpossible);
}

TEST(RulesInPacking, GapsAreFilledAroundZones) {
  Marker marker = with_zone();
  SumCache sums;
  const auto filled = refitting::fill_gaps(marker, {}, {sums});
  ASSERT_TRUE(filled) << filled.error().message;
  EXPECT_TRUE(is_valid(filled->marker));
  EXPECT_EQ(filled->marker.pieces[0].at, marker.pieces[0].at);
  const auto windows = refitting::compact_exactly(marker, {}, {sums});
  ASSERT_TRUE(windows) << windows.error().message;
  EXPECT_TRUE(is_valid(windows->marker));
}

TEST(RulesInPacking, GapsAreFilledByTheirRules) {
  Marker marker = squares(6);
  marker.pieces[0].rules.on_fold = true;
  marker.pieces[1].rules.to = 40'000;
  SumCache sums;
  const auto filled = refitting::fill_gaps(marker, {}, {sums});
  ASSERT_TRUE(filled) << filled.error().message;
  EXPECT_TRUE(is_valid(filled->marker));
}

}  // namespace
}  // namespace selvage::packing
