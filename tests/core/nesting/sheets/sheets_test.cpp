// Tests of core/nesting/sheets: its laws on random pieces and sheets, and corner cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"
#include "core/nesting/sheets/nest_on_sheets.h"
#include "tests/core/nesting/unplaced_pieces.h"
#include "tests/laws/random_marker.h"

namespace selvage::nesting::sheets {
namespace {

using test::kWidth;
using test::Random;
using test::rectangle;
using test::unplaced_pieces;

Sheet plain_sheet(Coord width, Coord length, std::size_t count = 1) {
  Sheet sheet;
  sheet.width = width;
  sheet.length = length;
  sheet.count = count;
  return sheet;
}

SheetNesting laid(const Marker& marker, const std::vector<Sheet>& sheets, std::uint64_t moves) {
  SumCache sums;
  SheetSettings settings;
  settings.moves = moves;
  settings.seed = 1;
  auto done = nest_on_sheets(marker, sheets, settings, {sums});
  if (!done) throw std::runtime_error{done.error().field + ": " + done.error().message};
  return *std::move(done);
}

std::multiset<std::string> ids_of(const SheetNesting& nesting) {
  std::multiset<std::string> ids;
  for (const SheetLayout& layout : nesting.layouts) {
    for (const Piece& piece : layout.marker.pieces) {
      if (!piece.rules.zone) ids.insert(piece.id);
    }
  }
  for (const Piece& piece : nesting.left_over) ids.insert(piece.id);
  return ids;
}

std::multiset<std::string> ids_of(const Marker& marker) {
  std::multiset<std::string> ids;
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) ids.insert(piece.id);
  }
  return ids;
}

// Whether no piece leaves the outline or covers a zone that it does not accept, tested corner by corner and edge by
// edge.
bool within_outline(const Marker& marker, const Sheet& sheet) {
  const marker::PlacedPieces pieces{marker};
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (pieces.is_zone(i)) continue;
    const Polygon placed = placed_outline(marker, PieceId{i});
    for (const Vec corner : placed) {
      if (sheet.outline && locate(corner, *sheet.outline) == geometry::Location::kOutside) return false;
    }
    for (const SheetZone& zone : sheet.zones) {
      if (zone.quality && marker.pieces[i].rules.quality >= zone.quality) continue;
      const geometry::PlacedPolygon there{zone.outline, box_of(zone.outline), {}};
      if (marker::collide(pieces[i], there, 0)) return false;
    }
  }
  return true;
}

TEST(Sheets, EveryPieceLiesOnAValidSheetOrIsLeftOver) {
  Random random{1};
  for (int trial = 0; trial < 25 / test::kSlowdown; ++trial) {
    Marker marker = test::random_marker(random);
    for (Piece& piece : marker.pieces) {
      piece.locked = {};
      piece.group.clear();
    }
    const Coord width = marker.strip.width;
    std::vector<Sheet> sheets{plain_sheet(width, length_of(marker) / 3 + 1, 2), plain_sheet(width / 2, width)};
    sheets[0].cost = trial % 3;
    const SheetNesting nesting = laid(marker, sheets, 200);
    EXPECT_EQ(ids_of(nesting), ids_of(marker)) << "trial " << trial;
    std::vector<std::size_t> used(sheets.size());
    for (const SheetLayout& layout : nesting.layouts) {
      EXPECT_TRUE(is_valid(layout.marker)) << "trial " << trial;
      EXPECT_TRUE(make_marker(layout.marker)) << "trial " << trial;
      EXPECT_FALSE(layout.marker.pieces.empty());
      EXPECT_EQ(layout.marker.strip.width, sheets[layout.sheet].width);
      EXPECT_EQ(layout.marker.strip.longest, sheets[layout.sheet].length);
      ++used[layout.sheet];
    }
    for (std::size_t kind = 0; kind < sheets.size(); ++kind) EXPECT_LE(used[kind], sheets[kind].count);
  }
}

TEST(Sheets, AreTheSameWhateverTheCacheHolds) {
  const Marker marker =
      unplaced_pieces({rectangle(300'000, 200'000), {{0, 0}, {400'000, 0}, {0, 250'000}}}, 30, kWidth);
  const std::vector<Sheet> sheets{plain_sheet(kWidth, kWidth, 2), plain_sheet(500'000, 700'000, 3)};
  SumCache sums;
  const SheetSettings settings{.moves = 1'000, .seed = 3};
  const auto first = nest_on_sheets(marker, sheets, settings, {sums});
  const auto again = nest_on_sheets(marker, sheets, settings, {sums});
  ASSERT_TRUE(first && again);
  ASSERT_EQ(first->layouts.size(), again->layouts.size());
  for (std::size_t k = 0; k < first->layouts.size(); ++k) {
    EXPECT_EQ(first->layouts[k].sheet, again->layouts[k].sheet);
    EXPECT_EQ(first->layouts[k].marker, again->layouts[k].marker);
  }
  EXPECT_EQ(first->left_over, again->left_over);
}

TEST(Sheets, FillsTheSheetsThatSquaresFillCompletely) {
  const Marker marker = unplaced_pieces({rectangle(250'000, 250'000)}, 32, kWidth);
  const SheetNesting nesting = laid(marker, {plain_sheet(kWidth, kWidth, 5)}, 5'000);
  EXPECT_EQ(nesting.layouts.size(), 2u);
  EXPECT_TRUE(nesting.left_over.empty());
  EXPECT_EQ(nesting.reason, scene::StopReason::kConverged);
}

TEST(Sheets, TakesTheSmallestSheetForTheRest) {
  const Marker marker = unplaced_pieces({rectangle(480'000, 480'000)}, 5, kWidth);
  const SheetNesting nesting = laid(
      marker, {plain_sheet(500'000, 500'000), plain_sheet(kWidth, kWidth, 3), plain_sheet(kWidth, 500'000)}, 2'000);
  ASSERT_EQ(nesting.layouts.size(), 2u);
  EXPECT_EQ(nesting.layouts[0].sheet, 1u);
  EXPECT_EQ(nesting.layouts[1].sheet, 0u);
  EXPECT_TRUE(nesting.left_over.empty());
}

std::vector<std::size_t> kinds_of(const SheetNesting& nesting) {
  std::vector<std::size_t> kinds;
  for (const SheetLayout& layout : nesting.layouts) kinds.push_back(layout.sheet);
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

TEST(Sheets, RemnantsThatCostNothingAreUsedFirst) {
  // A whole sheet holds four of the pieces, a remnant one.
  const Marker marker = unplaced_pieces({rectangle(480'000, 480'000)}, 5, kWidth);
  std::vector<Sheet> sheets{plain_sheet(kWidth, kWidth, 3), plain_sheet(500'000, 500'000, 6)};
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{0, 1}));
  sheets[1].cost = 0;
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{1, 1, 1, 1, 1}));
  sheets[1].count = 2;
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{0, 1, 1}));
  sheets[0].cost = 0;  // nothing costs anything: as few as possible
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{0, 1}));
}

TEST(Sheets, ASheetWithoutRoomDoesNotDisturbTheOrderOfTheOthers) {
  const Marker marker = unplaced_pieces({rectangle(480'000, 480'000)}, 4, kWidth);
  std::vector<Sheet> sheets{plain_sheet(kWidth, kWidth), plain_sheet(kWidth, kWidth), plain_sheet(kWidth, kWidth)};
  sheets[0].cost = 2;
  sheets[1].cost = 0;
  sheets[1].zones = {{rectangle(kWidth, kWidth)}};
  EXPECT_EQ(kinds_of(laid(marker, sheets, 500)), (std::vector<std::size_t>{2}));
}

TEST(Sheets, SeveralTakeThePlaceOfOneThatCostsMore) {
  // The large sheet is the cheapest for its area, but its pieces lie on two smaller ones that cost less.
  const Marker marker = unplaced_pieces({rectangle(480'000, 480'000)}, 3, kWidth);
  std::vector<Sheet> sheets{plain_sheet(10 * kWidth, 10 * kWidth), plain_sheet(500'000, kWidth, 3)};
  sheets[0].cost = 100;
  sheets[1].cost = 2;
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{1, 1}));
  sheets[1].cost = 50;
  EXPECT_EQ(kinds_of(laid(marker, sheets, 2'000)), (std::vector<std::size_t>{0}));
}

TEST(Sheets, ListsPiecesForWhichThereIsNoRoom) {
  Marker marker = unplaced_pieces({rectangle(600'000, 600'000), rectangle(1'200'000, 1'200'000)}, 6, kWidth);
  const SheetNesting nesting = laid(marker, {plain_sheet(kWidth, kWidth, 2)}, 500);
  EXPECT_EQ(nesting.layouts.size(), 2u);
  EXPECT_EQ(nesting.left_over.size(), 4u);
  for (const Piece& piece : nesting.left_over) EXPECT_EQ(piece.at, Vec{});
}

TEST(Sheets, SayWhetherTimeOrMovesWereUsedUp) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 400'000), rectangle(250'000, 100'000)}, 12, kWidth);
  const std::vector<Sheet> sheets{plain_sheet(900'000, 900'000)};
  const SheetNesting by_moves = laid(marker, sheets, 100);
  EXPECT_EQ(by_moves.reason, scene::StopReason::kWorkLimit);
  EXPECT_FALSE(by_moves.out_of_time);
  SumCache sums;
  SheetSettings settings;
  settings.moves = 1'000'000'000;
  settings.elapsed = [] { return 1.0; };
  const auto by_time = nest_on_sheets(marker, sheets, settings, {sums});
  ASSERT_TRUE(by_time);
  EXPECT_EQ(by_time->reason, scene::StopReason::kWorkLimit);
  EXPECT_TRUE(by_time->out_of_time);
}

TEST(Sheets, PreferPiecesOfHigherValue) {
  // One large piece or one small piece fits, not both.
  const Marker marker = unplaced_pieces({rectangle(800'000, 800'000), rectangle(300'000, 900'000)}, 2, kWidth);
  SumCache sums;
  SheetSettings settings;
  settings.moves = 500;
  const std::vector<Sheet> sheets{plain_sheet(900'000, 900'000)};
  const auto by_area = nest_on_sheets(marker, sheets, settings, {sums});
  ASSERT_TRUE(by_area);
  EXPECT_EQ(by_area->layouts[0].marker.pieces[0].id, "0");
  // The large piece covers 6.4e11 square units, which is also its value if none is given.
  using Values = decltype(settings.values);
  for (const Values& values : {Values{{"0", 1.0}, {"1", 5.0}}, Values{{"1", 7e11}}}) {
    settings.values = values;
    const auto by_value = nest_on_sheets(marker, sheets, settings, {sums});
    ASSERT_TRUE(by_value);
    ASSERT_EQ(by_value->layouts[0].marker.pieces.size(), 1u);
    EXPECT_EQ(by_value->layouts[0].marker.pieces[0].id, "1");
  }
}

TEST(Sheets, PiecesStayWithinAnOutlineAndOffItsHoles) {
  // An arrow head with a fault in its middle, away from the origin.
  const Polygon outline{{100'000, 0}, {1'500'000, 500'000}, {100'000, 1'000'000}, {400'000, 500'000}};
  const Polygon fault{{700'000, 450'000}, {800'000, 450'000}, {800'000, 550'000}, {700'000, 550'000}};
  const Sheet sheet = sheet_within(outline, {{fault}});
  EXPECT_EQ(sheet.length, 1'400'000);
  Marker marker = unplaced_pieces({rectangle(90'000, 60'000), {{0, 0}, {120'000, 0}, {0, 120'000}}}, 60, kWidth);
  for (const Coord spacing : {0, 2'001}) {
    marker.spacing = spacing;
    const SheetNesting nesting = laid(marker, {sheet}, 1'500);
    ASSERT_EQ(nesting.layouts.size(), 1u);
    const Marker& found = nesting.layouts[0].marker;
    EXPECT_GT(piece_count(found), 20u) << spacing;
    EXPECT_TRUE(is_valid(found)) << spacing;
    EXPECT_TRUE(within_outline(found, sheet)) << spacing;
    EXPECT_EQ(ids_of(nesting), ids_of(marker));
    EXPECT_EQ(found.spacing, spacing);
  }
}

TEST(Sheets, TheMarkerOfASheetKnowsItsForm) {
  // A wedge: compacting what lies in it never moves a piece over its edges.
  const Sheet sheet = sheet_within({{0, 0}, {1'000'000, 0}, {0, 1'000'000}}, {{rectangle(100'000, 100'000)}});
  const Marker marker = unplaced_pieces({rectangle(90'000, 60'000)}, 6, kWidth);
  const SheetNesting nesting = laid(marker, {sheet}, 200);
  ASSERT_EQ(nesting.layouts.size(), 1u);
  Marker found = nesting.layouts[0].marker;
  EXPECT_EQ(found.pieces.size(), 2 + 6u);
  EXPECT_EQ(found.pieces[0].id, "sheet edge 1");
  EXPECT_EQ(found.pieces[1].id, "sheet hole 1");
  ASSERT_TRUE(make_marker(found));
  found.pieces.back().at = {900'000, 900'000};
  EXPECT_FALSE(is_valid(found));
}

TEST(Sheets, OnlyPiecesThatAcceptItsQualityCoverAZone) {
  // Each sheet has room for one piece, over a zone of class 3 that leaves room for none beside it.
  const Sheet sheet{.width = 100'000,
                    .length = 100'000,
                    .zones = {{{{20'000, 20'000}, {80'000, 20'000}, {80'000, 80'000}, {20'000, 80'000}}, 3}},
                    .count = 4};
  Marker marker = unplaced_pieces({rectangle(60'000, 60'000)}, 4, kWidth);
  marker.unplaced[1].rules.quality = 2;
  marker.unplaced[2].rules.quality = 3;
  marker.unplaced[3].rules.quality = 9;
  const SheetNesting nesting = laid(marker, {sheet}, 500);
  EXPECT_EQ(nesting.layouts.size(), 2u);
  ASSERT_EQ(nesting.left_over.size(), 2u);
  EXPECT_EQ(nesting.left_over[0].id, marker.unplaced[0].id);
  EXPECT_EQ(nesting.left_over[1].id, marker.unplaced[1].id);
  EXPECT_EQ(area_of(sheet), 1e10);
}

TEST(Sheets, HolesMayOverlapAndReachBeyondTheSheet) {
  Sheet sheet = plain_sheet(100'000, 100'000);
  sheet.zones = {{{{-50'000, 0}, {40'000, 0}, {40'000, 100'000}, {-50'000, 100'000}}},
                 {{{20'000, 50'000}, {200'000, 50'000}, {200'000, 150'000}, {20'000, 150'000}}}};
  EXPECT_EQ(area_of(sheet), 60'000.0 * 50'000.0);
  const SheetNesting nesting = laid(unplaced_pieces({rectangle(60'000, 50'000)}, 2, kWidth), {sheet}, 200);
  ASSERT_EQ(nesting.layouts.size(), 1u);
  EXPECT_EQ(nesting.left_over.size(), 1u);
  EXPECT_EQ(nesting.layouts[0].marker.pieces.back().at, (Vec{40'000, 0}));
}

TEST(Sheets, WithAHideOfTheMostCornersKeepAllItsWalls) {
  // A parabola, closed by its chord: the wall below it has all corners of the outline, and one of the box.
  const auto parabola = [](Coord corners) {
    Polygon outline;
    for (Coord k = 0; k < corners; ++k) outline.push_back({1'000 * k, k * k});
    return outline;
  };
  const Marker marker = unplaced_pieces({rectangle(900'000, 900'000)}, 1, kWidth);
  const SheetNesting nesting = laid(marker, {sheet_within(parabola(1'996), {})}, 100);
  EXPECT_TRUE(nesting.layouts.empty());
  SumCache sums;
  const std::vector<Sheet> larger{sheet_within(parabola(1'997), {})};
  const auto refused = nest_on_sheets(marker, larger, {.moves = 100}, {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kTooManyVertices);
  EXPECT_EQ(refused.error().field, "/sheets/0/outline");
}

TEST(Sheets, WithZonesHavePiecesEvenWithoutABudget) {
  Sheet sheet = plain_sheet(kWidth, kWidth, 4);
  sheet.zones = {{rectangle(250'000, 250'000)}};
  const Marker marker = unplaced_pieces({rectangle(200'000, 200'000)}, 60, kWidth);
  const SheetNesting nesting = laid(marker, {sheet}, 0);
  EXPECT_TRUE(nesting.left_over.empty());
  for (const SheetLayout& layout : nesting.layouts) EXPECT_TRUE(is_valid(layout.marker));
}

// Pieces that were taken off one sheet to make room for another piece go to a free one.
TEST(Sheets, WhatIsLeftOverFitsNoFreeSheet) {
  Random random{23};
  int tested = 0;  // trials in which a piece was left over, and a sheet
  for (int trial = 0; trial < 20 / test::kSlowdown; ++trial) {
    const auto side = [&] { return random.between(50'000, 500'000); };
    std::vector<Polygon> outlines;
    for (int k = 0; k < 6; ++k) outlines.push_back(rectangle(side(), side()));
    const Marker marker = unplaced_pieces(outlines, 12, kWidth);
    const std::vector<Sheet> sheets{plain_sheet(400'000, 600'000, 2), plain_sheet(250'000, 300'000, 4)};
    const SheetNesting nesting = laid(marker, sheets, 8'000);
    if (nesting.reason != scene::StopReason::kConverged) continue;
    std::vector<std::size_t> used(sheets.size());
    for (const SheetLayout& layout : nesting.layouts) ++used[layout.sheet];
    for (std::size_t kind = 0; kind < sheets.size(); ++kind) {
      if (used[kind] == sheets[kind].count) continue;
      tested += nesting.left_over.empty() ? 0 : 1;
      for (const Piece& piece : nesting.left_over) {
        const Box box = box_of(marker.shapes[piece.shape.value].outline);
        EXPECT_TRUE(box.width() > sheets[kind].length || box.height() > sheets[kind].width) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(tested, 0);
}

TEST(Sheets, PiecesThatFitNoSheetDoNotHideThoseThatDo) {
  // Every second piece is too long, and more pieces are left over than are offered at once.
  const Marker marker = unplaced_pieces({rectangle(600'000, 10'000), rectangle(10'000, 10'000)}, 1'600, kWidth);
  const SheetNesting nesting = laid(marker, {plain_sheet(300'000, 300'000, 3)}, 0);
  EXPECT_EQ(nesting.left_over.size(), 800u);
}

TEST(Sheets, WithoutABudgetAreStillValid) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(100'000, 400'000)}, 40, kWidth);
  const SheetNesting nesting = laid(marker, {plain_sheet(kWidth, kWidth, 9)}, 0);
  EXPECT_EQ(ids_of(nesting), ids_of(marker));
  EXPECT_FALSE(nesting.layouts.empty());
  for (const SheetLayout& layout : nesting.layouts) EXPECT_TRUE(is_valid(layout.marker));
}

TEST(Sheets, KeepTheBestWhenTheyAreCancelled) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 200'000)}, 40, kWidth);
  std::stop_source stop;
  stop.request_stop();
  SumCache sums;
  SheetSettings settings;
  settings.moves = 1'000'000;
  const std::vector<Sheet> sheets{plain_sheet(kWidth, kWidth, 9)};
  const auto nesting = nest_on_sheets(marker, sheets, settings, {sums, stop.get_token()});
  ASSERT_TRUE(nesting);
  EXPECT_EQ(nesting->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(ids_of(*nesting), ids_of(marker));
}

TEST(Sheets, RefuseInvalidInput) {
  Marker marker = unplaced_pieces({rectangle(300'000, 200'000)}, 3, kWidth);
  SumCache sums;
  const SheetSettings settings;
  const auto refusal = [&](const Marker& pieces, const Sheet& sheet) {
    const auto done = nest_on_sheets(pieces, std::vector<Sheet>{plain_sheet(kWidth, kWidth), sheet}, settings, {sums});
    return done ? std::string{} : done.error().field;
  };
  EXPECT_EQ(refusal(marker, plain_sheet(0, kWidth)), "/sheets/1");
  Sheet holed = plain_sheet(kWidth, kWidth);
  holed.zones = {{rectangle(400, 400)}};
  EXPECT_EQ(refusal(marker, holed), "");
  marker.strip.margin = 10;
  EXPECT_EQ(refusal(marker, holed), "");
  EXPECT_EQ(refusal(marker, sheet_within({{0, 0}, {kWidth, 0}, {0, kWidth}}, {})), "/sheets/1/outline");
  marker.strip.margin = 0;
  marker.unplaced[1].group = "g";
  EXPECT_EQ(refusal(marker, holed), "/unplaced/1/group");
  marker.unplaced[1].group.clear();
  marker.pieces = {marker.unplaced[0]};
  marker.unplaced.erase(marker.unplaced.begin());
  marker.pieces[0].locked = true;
  EXPECT_EQ(refusal(marker, holed), "/pieces/0/locked");
  marker.pieces.clear();
  marker.unplaced.clear();
  const auto none = nest_on_sheets(marker, std::vector<Sheet>{plain_sheet(kWidth, kWidth)}, settings, {sums});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kEmptyMarker);
}

}  // namespace
}  // namespace selvage::nesting::sheets
