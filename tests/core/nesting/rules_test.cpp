// Cloth's rules in nesting: every method of placing pieces keeps them, and fails only if no layout is found.
#include "core/marker/rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/validity.h"
#include "core/nesting/nest.h"
#include "core/nesting/sheets/nest_on_sheets.h"
#include "core/nesting/start/first_layout.h"
#include "tests/core/nesting/unplaced_pieces.h"
#include "tests/laws/random_marker.h"

namespace selvage::nesting {
namespace {

using test::kSide;
using test::kWidth;
using test::rectangle;
using test::unplaced_pieces;

Result<Nesting> nested(const Marker& marker, std::uint64_t moves) {
  SumCache sums;
  NestSettings settings;
  settings.moves = moves;
  settings.tuning.first_epoch = 40;
  return nest(marker, settings, {sums});
}

Marker squares(std::size_t count) {
  return unplaced_pieces({rectangle(3 * kSide, 3 * kSide)}, count, kWidth);
}

// The rules of random markers can be kept, because the markers keep them; the search nearly always finds a layout.
TEST(RulesInNesting, RandomMarkersAreNestedAnew) {
  test::Random random{7};
  int trials = 0, found = 0;
  for (; trials < 60 / test::kSlowdown; ++trials) {
    const Marker marker = test::taken_off(test::random_marker_with_rules(random));
    const auto done = nested(marker, 100);
    if (!done) {
      EXPECT_EQ(done.error().code, ErrorCode::kOutOfRange) << trials << ": " << done.error().message;
      continue;
    }
    ++found;
    EXPECT_TRUE(is_valid(done->marker)) << trials;
    EXPECT_TRUE(make_marker(done->marker)) << trials << ": " << make_marker(done->marker).error().message;
    EXPECT_EQ(done->marker.pieces.size() + done->marker.unplaced.size(), marker.pieces.size() + marker.unplaced.size());
  }
  EXPECT_GE(10 * found, 9 * trials) << found << " of " << trials;
}

TEST(RulesInNesting, FoldedPiecesLieOnTheFoldWithAFlatSide) {
  // A roof that is flat on one side only; rotated by 180 degrees it could not lie on the fold.
  Marker marker = unplaced_pieces({{{0, 0}, {4 * kSide, 0}, {2 * kSide, 2 * kSide}}}, 6, kWidth);
  marker.shapes[0].rotations = {{0}, {180}};
  marker.strip.below = 20'000;
  for (std::size_t i = 0; i < 3; ++i) marker.unplaced[i].rules.on_fold = true;
  const auto done = nested(marker, 2000);
  ASSERT_TRUE(done) << done.error().message;
  ASSERT_EQ(done->marker.pieces.size(), 6u);
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_TRUE(make_marker(done->marker));
  for (std::size_t i = 0; i < 6; ++i) {
    const Box box = box_of(placed_outline(done->marker, PieceId{static_cast<std::uint32_t>(i)}));
    EXPECT_EQ(box.low.y == 0, i < 3) << i;
  }
}

TEST(RulesInNesting, BandsAndSelvedgesOfTheirOwnAreKept) {
  Marker marker = squares(12);
  marker.strip.below = 50'000;
  marker.strip.above = 40'000;  // three squares across, if one of them may lie in a selvedge
  for (std::size_t i = 0; i < 4; ++i) marker.unplaced[i].rules.above = 0;
  for (std::size_t i = 4; i < 7; ++i) marker.unplaced[i].rules.to = 7 * kSide;
  marker.unplaced[7].rules.from = 5 * kSide;
  const auto done = nested(marker, 3000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->marker.pieces.size(), 12u);
  EXPECT_LE(done->length_after, 15 * kSide);
}

TEST(RulesInNesting, OverlapAllowancesAreUsed) {
  // Two pieces next to each other fit the width only because of their allowance.
  Marker marker = unplaced_pieces({rectangle(300'000, 501'000)}, 8, kWidth);
  for (Shape& shape : marker.shapes) shape.rotations = {{0}};
  marker.overlap = 2'000;
  const auto allowed = nested(marker, 4'000);
  ASSERT_TRUE(allowed) << allowed.error().message;
  EXPECT_TRUE(is_valid(allowed->marker));
  EXPECT_LE(allowed->length_after, 4 * 300'000 - 3 * 2'000 + 100);
  marker.overlap = 0;
  const auto refused = nested(marker, 400);
  ASSERT_TRUE(refused) << refused.error().message;
  EXPECT_GT(refused->length_after, 2'000'000);
}

TEST(RulesInNesting, PiecesOfAShadeStayTogetherWhateverElseMoves) {
  Marker marker = squares(18);
  marker.shade = 7 * kSide;  // room for six
  for (std::size_t i = 0; i < 12; ++i) marker.unplaced[i].rules.shade = i % 2 == 0 ? "A" : "B";
  const auto done = nested(marker, 3000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->marker.pieces.size(), 18u);
  EXPECT_LE(done->length_after, 19 * kSide);
}

TEST(RulesInNesting, MatchedPiecesLieWhereRepeatsBegin) {
  Marker marker = squares(9);
  for (const bool plaid : {false, true}) {
    marker.strip.repeat = {.along = 7 * kSide / 2, .across = plaid ? 3 * kSide + 7'000 : 0, .phase = {12'345, 321}};
    for (std::size_t i = 0; i < 5; ++i) marker.unplaced[i].rules.match = Vec{kSide, kSide / 3};
    const auto done = nested(marker, 2000);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_TRUE(is_valid(done->marker));
    EXPECT_EQ(done->marker.pieces.size(), 9u);
    EXPECT_LE(done->length_after, 15 * kSide);
  }
}

TEST(RulesInNesting, MatchSetsKeepThePhaseOfAPieceThatIsLocked) {
  Marker marker = squares(9);
  marker.strip.repeat = {.along = 7 * kSide / 2, .phase = {12'345, 321}};
  for (std::size_t i = 0; i < 6; ++i) {
    marker.unplaced[i].rules.match = Vec{kSide, kSide / 3};
    marker.unplaced[i].rules.match_set = i < 3 ? "A" : "B";
  }
  marker.pieces.push_back(marker.unplaced[0]);
  marker.unplaced.erase(marker.unplaced.begin());
  marker.pieces[0].at = {kSide / 5, 0};
  marker.pieces[0].locked = true;
  const auto done = nested(marker, 2000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  ASSERT_EQ(done->marker.pieces.size(), 9u);
  EXPECT_EQ(done->marker.pieces[0].at, marker.pieces[0].at);
  EXPECT_EQ(done->marker.pieces[1].rules, marker.unplaced[0].rules);  // as they were given
}

TEST(RulesInNesting, MatchSetsKeepThePhaseOfAPlacedPieceWhenOthersDoNotFitAsTheyAreTurned) {
  Marker marker = unplaced_pieces({rectangle(12 * kSide, kSide)}, 4, kWidth);
  marker.strip.repeat = {.along = 0, .across = 2 * kSide, .phase = {}};
  for (Piece& piece : marker.unplaced) {
    piece.rules.match = Vec{};
    piece.rules.match_set = "A";
  }
  marker.pieces.push_back(marker.unplaced.back());
  marker.unplaced.pop_back();
  marker.pieces[0].at = {0, kSide / 3};
  marker.pieces[0].locked = true;
  for (Piece& piece : marker.unplaced) piece.orientation.rotation = {90};  // longer than the strip is wide
  const auto done = nested(marker, 500);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(done->marker.pieces.size(), 4u);
}

TEST(RulesInNesting, APlacedPieceThatItsMatchSetLeavesNoRoomIsNamed) {
  // The locked piece has the set begin repeats at a height where the large one would leave the strip.
  Marker marker = unplaced_pieces({rectangle(kSide, kSide), rectangle(kSide, 9 * kSide)}, 2, kWidth);
  marker.strip.repeat = {.along = 0, .across = kWidth / 2, .phase = {}};
  for (Shape& shape : marker.shapes) shape.rotations = {{0}};
  marker.pieces = std::move(marker.unplaced);
  marker.unplaced.clear();
  for (Piece& piece : marker.pieces) {
    piece.rules.match = Vec{};
    piece.rules.match_set = "A";
  }
  marker.pieces[0].at = {0, kWidth / 4};
  marker.pieces[0].locked = true;
  marker.pieces[1].at = {3 * kSide, 0};
  const auto refused = nested(marker, 100);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kPieceTooWide);
  EXPECT_EQ(refused.error().field, "/pieces/1");
}

TEST(RulesInNesting, ReportedMarkersHaveTheRulesThatWereGiven) {
  Marker marker =
      unplaced_pieces({rectangle(3 * kSide, 2 * kSide), {{0, 0}, {4 * kSide, 0}, {0, 3 * kSide}}}, 12, kWidth);
  marker.strip.repeat = {.along = 7 * kSide / 2, .phase = {12'345, 321}};
  for (std::size_t i = 0; i < 3; ++i) {
    marker.unplaced[i].rules.match = Vec{kSide, kSide / 3};
    marker.unplaced[i].rules.match_set = "A";
  }
  SumCache sums;
  scene::Run run{sums};
  int reported = 0;
  run.observer.on_round = [&](const scene::Round& round) {
    ASSERT_TRUE(round.marker);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(round.marker->pieces[i].rules, marker.unplaced[i].rules);
    ++reported;
  };
  NestSettings settings;
  settings.moves = 2'000;
  ASSERT_TRUE(nest(marker, settings, run));
  EXPECT_GT(reported, 0);
}

TEST(RulesInNesting, PiecesWithANapLieInItsDirection) {
  Marker marker = unplaced_pieces({{{0, 0}, {4 * kSide, 0}, {2 * kSide, 2 * kSide}, {0, kSide}}}, 8, kWidth);
  const auto nap_of = [](std::size_t i) { return i % 2 == 0 ? marker::Nap::kUp : marker::Nap::kDown; };
  for (std::size_t i = 0; i < 6; ++i) marker.unplaced[i].rules.nap = nap_of(i);
  const auto done = nested(marker, 1500);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_TRUE(make_marker(done->marker));
  ASSERT_EQ(done->marker.pieces.size(), 8u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Piece& piece = done->marker.pieces[i];
    EXPECT_EQ(piece.orientation.rotation.degrees, piece.rules.nap == marker::Nap::kUp ? 0 : 180) << i;
  }
}

// A flaw in the middle of the cloth, and one behind all pieces that reaches beyond both edges.
Marker on_flawed_cloth(std::size_t count) {
  Marker marker = squares(count);
  marker.shapes.push_back({.id = "flaw", .outline = rectangle(2 * kSide, 2 * kSide), .tilt_limit = {}});
  marker.shapes.push_back({.id = "splice", .outline = rectangle(kSide, 2 * kWidth), .tilt_limit = {}});
  const auto zone = [&marker](std::string id, std::uint32_t shape, Vec at) {
    marker.pieces.push_back({.id = std::move(id), .shape = {shape}, .orientation = {}, .at = at});
    marker.pieces.back().rules.zone = true;
  };
  zone("flaw", 1, {4 * kSide, 4 * kSide});
  zone("splice", 2, {18 * kSide, -kWidth / 2});
  return *make_marker(std::move(marker));
}

TEST(RulesInNesting, NoPieceLiesOnAZone) {
  const Marker marker = on_flawed_cloth(12);
  const auto done = nested(marker, 3000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_EQ(piece_count(done->marker), 12u);
  EXPECT_TRUE(done->marker.unplaced.empty());
  EXPECT_LE(done->length_after, 18 * kSide) << "the splice is farther than the pieces need to reach";
  EXPECT_EQ(done->marker.pieces[0].at, marker.pieces[0].at);
  EXPECT_EQ(done->marker.pieces[1].at, marker.pieces[1].at);
}

TEST(RulesInNesting, PiecesThatAcceptAQualityLieOnItsZone) {
  // A zone that leaves less room on both sides of it than the pieces need.
  Marker marker = squares(8);
  marker.shapes.push_back({.id = "stain", .outline = rectangle(20 * kSide, kWidth), .tilt_limit = {}});
  marker.pieces.push_back({.id = "stain", .shape = {1}, .orientation = {}, .at = {4 * kSide, 0}});
  marker.pieces[0].rules = {.zone = true, .quality = 2};
  marker = *make_marker(std::move(marker));
  for (std::size_t i = 0; i < 5; ++i) marker.unplaced[i].rules.quality = 2;
  for (std::size_t i = 5; i < 8; ++i) marker.unplaced[i].rules.quality = 1;
  const auto done = nested(marker, 2000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  ASSERT_EQ(piece_count(done->marker), 8u);
  EXPECT_LT(done->length_after, 12 * kSide) << "those that accept it need not lie behind it";
  for (std::uint32_t i = 6; i < 9; ++i) EXPECT_LE(box_of(placed_outline(done->marker, PieceId{i})).high.x, 4 * kSide);
}

TEST(RulesInNesting, OnlyThePartsThatAcceptAQualityLieOnItsZone) {
  // Between two stains there is room for the part of a square, which is two thirds of it, and not for a whole one.
  Marker marker = squares(6);
  marker.shapes.push_back({.id = "stain", .outline = rectangle(3 * kSide, kWidth), .tilt_limit = {}});
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto x = static_cast<Coord>(k) * 11 * kSide / 2;
    marker.pieces.push_back({.id = "stain " + std::to_string(k), .shape = {1}, .orientation = {}, .at = {x, 0}});
    marker.pieces.back().rules = {.zone = true, .quality = 1};
  }
  for (Piece& piece : marker.unplaced) {
    piece.rules.quality = 1;
    piece.rules.part = marker::Part{rectangle(2 * kSide, 3 * kSide), 0};
  }
  marker = *make_marker(std::move(marker));
  const auto done = nested(marker, 4000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  ASSERT_EQ(piece_count(done->marker), 6u);
  EXPECT_LT(done->length_after, 14 * kSide) << "all lie before the end of the last stain";
}

TEST(RulesInNesting, HalfPiecesLieOnBothFoldsOfATube) {
  Marker marker = unplaced_pieces({{{0, 0}, {4 * kSide, 0}, {2 * kSide, 4 * kSide}}}, 6, kWidth);
  marker.shapes[0].rotations = {{0}, {180}};
  for (Piece& piece : marker.unplaced) piece.rules.on_fold = true;
  marker.strip.tube = true;
  const auto done = nested(marker, 6000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_TRUE(make_marker(done->marker));
  int lower = 0, upper = 0;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const Box box = box_of(placed_outline(done->marker, PieceId{i}));
    lower += box.low.y == 0 ? 1 : 0;
    upper += box.high.y == kWidth ? 1 : 0;
  }
  EXPECT_EQ(lower + upper, 6);
  EXPECT_EQ(lower, 3);
  EXPECT_LE(done->length_after, 13 * kSide) << "on one fold alone they would take 24 sides";
}

TEST(RulesInNesting, ZonesStayOnShortCloth) {
  Marker marker = on_flawed_cloth(14);
  marker.strip.longest = 10 * kSide;
  const auto done = nested(marker, 3000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_TRUE(make_marker(done->marker)) << make_marker(done->marker).error().message;
  EXPECT_GE(piece_count(done->marker), 5u);
  EXPECT_EQ(piece_count(done->marker) + done->left_over, 14u);
}

TEST(RulesInNesting, ZonesAreNotPartOfSheets) {
  sheets::Sheet sheet;
  sheet.width = sheet.length = kWidth;
  SumCache sums;
  const auto done = sheets::nest_on_sheets(on_flawed_cloth(2), {&sheet, 1}, {.moves = 200, .seed = 1}, {sums});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().field, "/pieces/0/rules/zone");
}

TEST(RulesInNesting, ABandThatIsTooShortIsAnErrorThatNamesAPiece) {
  Marker marker = squares(5);
  for (Piece& piece : marker.unplaced) piece.rules.to = 4 * kSide;
  const auto done = nested(marker, 500);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kOutOfRange);
  EXPECT_NE(done.error().message.find("piece \""), std::string::npos) << done.error().message;
}

TEST(RulesInNesting, APieceWiderThanItsRoomIsRefused) {
  Marker marker = squares(2);
  marker.unplaced[1].rules.below = 800'000;
  const auto done = nested(marker, 500);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kPieceTooWide);
  EXPECT_EQ(done.error().field, "/unplaced/1");
}

TEST(RulesInNesting, OnShortClothPlacedPiecesKeepTheRules) {
  Marker marker = squares(14);
  marker.strip.longest = 10 * kSide;
  marker.shade = 4 * kSide;
  for (std::size_t i = 0; i < 3; ++i) marker.unplaced[i].rules.shade = "A";
  for (std::size_t i = 3; i < 6; ++i) marker.unplaced[i].rules.to = 4 * kSide;
  marker.unplaced[6].rules.on_fold = true;
  const auto done = nested(marker, 3000);
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  EXPECT_GE(done->marker.pieces.size(), 8u);
  EXPECT_EQ(done->marker.pieces.size() + done->left_over, 14u);
}

TEST(RulesInNesting, SheetsKeepTheRules) {
  test::Random random{3};
  for (int trial = 0; trial < 12 / test::kSlowdown; ++trial) {
    Marker marker = test::random_marker_with_rules(random);
    std::erase_if(marker.pieces, [](const Piece& piece) { return piece.rules.zone; });  // of another cloth
    for (Piece& piece : marker.pieces) {
      piece.locked = {};
      piece.group.clear();
    }
    sheets::Sheet sheet;
    sheet.width = marker.strip.width;
    sheet.length = std::max<Coord>(marker.strip.width / 2, length_of(marker) * 2 / 3);
    sheet.count = 2;
    sheet.zones = {{test::rectangle(sheet.width / 20, sheet.width / 20)}};
    SumCache sums;
    const auto done = sheets::nest_on_sheets(marker, {&sheet, 1}, {.moves = 200, .seed = 1}, {sums});
    ASSERT_TRUE(done) << done.error().message;
    std::size_t pieces = done->left_over.size();
    for (const sheets::SheetLayout& layout : done->layouts) {
      EXPECT_TRUE(is_valid(layout.marker)) << trial;
      EXPECT_TRUE(layout.marker.pieces[0].rules.zone);
      pieces += piece_count(layout.marker);
    }
    EXPECT_EQ(pieces, marker.pieces.size());
  }
}

}  // namespace
}  // namespace selvage::nesting
