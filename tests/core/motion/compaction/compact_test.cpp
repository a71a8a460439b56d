#include "core/motion/compaction/compact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::compaction {
namespace {

using test::Layout;

const CompactionSettings kStandard = compaction_settings(Accuracy::kStandard);

Compaction compacted(const Marker& marker, const CompactionSettings& settings = kStandard) {
  SumCache sums;
  const auto result = compact(marker, settings, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before + result->repair.lengthened);
  EXPECT_EQ(result->length_after, length_of(result->marker));
  return *result;
}

TEST(Compact, SlidesOnePieceToTheLeftEdge) {
  Layout layout{1000};
  layout.put(layout.shape_of(test::rectangle(300, 200)), {5000, 400});
  const auto result = compacted(layout.marker());
  EXPECT_EQ(result.length_after, 300);
  EXPECT_EQ(result.marker.pieces[0].at.x, 0);
  EXPECT_EQ(result.reason, scene::StopReason::kConverged);
}

TEST(Compact, ClosesGapsBetweenRectanglesExactly) {
  Layout layout{1000};
  const auto tall = layout.shape_of(test::rectangle(100, 1000));
  for (int k = 0; k < 5; ++k) layout.put(tall, {k * 137, 0});
  EXPECT_EQ(compacted(layout.marker()).length_after, 500);
}

// A wedge whose tip fills the gap of 100 units between two squares.  It can only advance while the upper square moves
// aside, so no leftward motion of a single piece gains anything [Li94 1.2.2].
Layout wedge_between_squares(Coord width) {
  Layout layout{width};
  const auto square = layout.shape_of(test::rectangle(1000, 1000));
  const auto wedge = layout.shape_of({{0, 500}, {1000, 0}, {1000, 1000}});
  layout.put(square, {0, 0}).put(square, {0, 1100}).put(wedge, {900, 550}).put(square, {1900, 550});
  return layout;
}

TEST(Compact, MovesAPieceAsideToLetAnotherPass) {
  const auto result = compacted(wedge_between_squares(2500).marker());
  EXPECT_GE(result.length_after, 2500);  // the wedge enters until its width fills the room of 500 units
  EXPECT_LE(result.length_after, 2504);  // each slanted contact keeps a margin of a unit or two
  EXPECT_GE(result.marker.pieces[1].at.y - result.marker.pieces[0].at.y, 1498);
}

TEST(Compact, CannotWedgeApartPiecesThatTheEdgesHold) {
  const Marker marker = wedge_between_squares(2100).marker();
  const auto result = compacted(marker);
  EXPECT_EQ(result.length_after, result.length_before);
  EXPECT_EQ(result.marker.pieces[0].at, marker.pieces[0].at);
  EXPECT_EQ(result.marker.pieces[1].at, marker.pieces[1].at);
}

TEST(Compact, KeepsLockedPiecesToTheUnit) {
  Marker marker = test::loose_marker(7);
  for (std::size_t k : {3U, 8U, 12U}) marker.pieces[k].locked = true;
  const auto result = compacted(marker);
  for (std::size_t k : {3U, 8U, 12U}) EXPECT_EQ(result.marker.pieces[k].at, marker.pieces[k].at);
  EXPECT_LT(result.length_after, result.length_before);
}

TEST(Compact, DoesNotChangeAMarkerOfLockedPieces) {
  Marker marker = test::loose_marker(7);
  for (Piece& piece : marker.pieces) piece.locked = true;
  const auto result = compacted(marker);
  EXPECT_EQ(result.marker, marker);
  EXPECT_EQ(result.rounds, 0);
}

TEST(Compact, HoldsTheSpacingExactly) {
  for (const Coord spacing : {Coord{1}, Coord{1000}, Coord{20'000}}) {
    Marker marker = test::loose_marker(11);
    marker.spacing = spacing;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) marker.pieces[k].at.x += 30'000 * static_cast<Coord>(k / 3);
    marker.strip.width += 4 * 30'000;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) marker.pieces[k].at.y += 30'000 * static_cast<Coord>(k % 3);
    const auto result = compacted(marker);
    EXPECT_LT(result.length_after, result.length_before);
    EXPECT_TRUE(is_valid(result.marker));
  }
}

TEST(Compact, UsesTheAllowanceOfEveryContact) {
  Layout layout{400};
  const auto brick = layout.shape_of(test::rectangle(200, 100));
  for (int k = 0; k < 5; ++k) layout.put(brick, {k * 200, 0});
  layout.overlapping(9);
  const auto result = compacted(layout.marker());
  EXPECT_EQ(result.length_after, 1000 - 4 * 9);
  EXPECT_EQ(compacted(result.marker).length_after, result.length_after);
}

TEST(Compact, IsShorterTheMoreItMayOverlap) {
  auto result = compacted(test::loose_marker(11));
  for (const Coord more : {Coord{2000}, Coord{3000}}) {
    Marker marker = result.marker;
    marker.overlap += more;
    const Coord longer = result.length_after;
    result = compacted(marker);
    EXPECT_TRUE(is_valid(result.marker));
    EXPECT_LT(result.length_after, longer - more);  // each of the six columns may give way
  }
}

TEST(Compact, FindsNothingInBricksWithoutSlack) {
  Layout layout{400};
  const auto brick = layout.shape_of(test::rectangle(200, 100));
  for (int row = 0; row < 4; ++row) {
    for (int k = 0; k < 10; ++k) layout.put(brick, {k * 200 + (row % 2) * 100, row * 100});
  }
  const auto half = layout.shape_of(test::rectangle(100, 100));
  layout.put(half, {0, 100}).put(half, {0, 300});
  const auto result = compacted(layout.marker());
  EXPECT_EQ(result.length_after, 2100);
}

TEST(Compact, FindsNothingInInterlockedChevrons) {
  Layout layout{10'000};
  const auto band = layout.shape_of(test::chevron(7001, 1000, 333));
  for (int row = 0; row < 9; ++row) layout.put(band, {0, row * 1000});
  const auto result = compacted(layout.marker());
  EXPECT_EQ(result.length_after, 7001);
}

TEST(Compact, RemovesTheSlackBetweenChevronsThatFillTheStrip) {
  Layout layout{3 * 1000 + 333};
  const auto band = layout.shape_of(test::chevron(7001, 1000, 333));
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) layout.put(band, {column * 7101, row * 1000});
  }
  EXPECT_EQ(compacted(layout.marker()).length_after, 3 * 7001);
}

TEST(Compact, AcceptsPiecesExactlyAsWideAsTheStrip) {
  Layout layout{1000};
  const auto diamond = layout.shape_of({{0, 500}, {300, 0}, {600, 500}, {300, 1000}});
  for (int k = 0; k < 6; ++k) layout.put(diamond, {k * 700, 0});
  // Diamonds of full width meet corner to corner; each of the five slanted contacts keeps its margin of a few units.
  const auto after = compacted(layout.marker()).length_after;
  EXPECT_GE(after, 6 * 600);
  EXPECT_LE(after, 6 * 600 + 5 * 4);
}

// Two squares as wide as the strip overlap slightly, so their repair needs more length than there is.
TEST(Compact, RespectsTheClothsEnd) {
  constexpr Coord kSide = 100'000;
  Layout layout{kSide};
  const auto square = layout.shape_of(test::rectangle(kSide, kSide));
  layout.put(square, {0, 0}).put(square, {kSide - 5, 0});
  Marker marker = layout.marker();
  EXPECT_EQ(compacted(marker).length_after, 2 * kSide);
  marker.strip.longest = 2 * kSide;
  EXPECT_EQ(compacted(marker).length_after, 2 * kSide);
  marker.strip.longest = 2 * kSide - 1;
  SumCache sums;
  const auto refused = compact(marker, kStandard, {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kRepairFailed);
}

TEST(Compact, NoRoundIsLongerThanTheOneBefore) {
  SumCache sums;
  Coord last = length_of(test::loose_marker(5));
  int rounds = 0;
  scene::Observer observer;
  observer.on_round = [&](const scene::Round& round) {
    EXPECT_GT(round.number, rounds);  // sweeps with their rounds are reported together
    rounds = round.number;
    EXPECT_LE(round.length, last);
    last = round.length;
  };
  const auto result = compact(test::loose_marker(5), kStandard, {sums, {}, observer});
  ASSERT_TRUE(result);
  EXPECT_GE(result->rounds, rounds);
  EXPECT_EQ(result->length_after, last);
  EXPECT_LT(result->length_after, result->length_before);
}

TEST(Compact, StopsAtTheWorkLimit) {
  CompactionSettings settings = kStandard;
  settings.rounds = 1;
  const auto result = compacted(test::loose_marker(5), settings);
  EXPECT_EQ(result.rounds, 1);
  EXPECT_EQ(result.reason, scene::StopReason::kWorkLimit);
  settings.rounds = 0;
  EXPECT_EQ(compacted(test::loose_marker(5), settings).marker, test::loose_marker(5));
}

TEST(Compact, ReturnsTheBestSoFarWhenCancelled) {
  std::stop_source source;
  SumCache sums;
  scene::Observer observer;
  observer.on_round = [&](const scene::Round& round) {
    if (round.number == 1) source.request_stop();
  };
  const auto result = compact(test::loose_marker(5), kStandard, {sums, source.get_token(), observer});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(result->rounds, 1);
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LT(result->length_after, result->length_before);
}

TEST(Compact, ReturnsTheInputWhenCancelledBeforeItStarts) {
  std::stop_source source;
  source.request_stop();
  SumCache sums;
  const auto result = compact(test::loose_marker(5), kStandard, {sums, source.get_token()});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(result->marker, test::loose_marker(5));
}

TEST(Compact, GivesTheSameAnswerWithAColdAndAWarmCache) {
  SumCache warm;
  SumCache tiny{1};
  const Marker marker = test::loose_marker(9);
  const auto first = compact(marker, kStandard, {warm});
  const auto second = compact(marker, kStandard, {warm});
  const auto third = compact(marker, kStandard, {tiny});
  ASSERT_TRUE(first && second && third);
  EXPECT_EQ(first->marker, second->marker);
  EXPECT_EQ(first->marker, third->marker);
  EXPECT_EQ(warm.counts().misses, warm.counts().entries);
}

TEST(Compact, EveryRuleAndSolverGivesAValidShorterMarker) {
  for (const model::RegionRule rule : {model::RegionRule::kGreedy, model::RegionRule::kWalk}) {
    for (const lp::solver::SolverChoice solver :
         {lp::solver::SolverChoice::kSimplex, lp::solver::SolverChoice::kInteriorPoint}) {
      CompactionSettings settings = kStandard;
      settings.region = rule;
      settings.solver = solver;
      const auto result = compacted(test::loose_marker(13), settings);
      EXPECT_LT(static_cast<double>(result.length_after), 0.97 * static_cast<double>(result.length_before));
    }
  }
}

TEST(Compact, CompactingAgainGainsNothing) {
  const auto once = compacted(test::loose_marker(21));
  const auto twice = compacted(once.marker);
  EXPECT_LE(static_cast<double>(once.length_after - twice.length_after),
            1e-5 * static_cast<double>(once.marker.strip.width));
}

// Every round counts as hard, so that sections are used between the first one and the last ones.
TEST(Compact, ReportsPassesOverSectionsAsRounds) {
  Layout layout{1000};
  const auto wedge = layout.shape_of({{0, 0}, {300, 100}, {0, 200}});
  for (int k = 0; k < 120; ++k) layout.put(wedge, {320 * (k / 4), 250 * (k % 4)});
  CompactionSettings settings = kStandard;
  settings.tuning.sections.many = 100;
  settings.tuning.sections.pieces = 30;
  settings.tuning.hard_round = 1;
  settings.sweeps = false;
  SumCache sums;
  std::vector<scene::Round> rounds;
  scene::Run run{sums};
  run.observer.on_round = [&](const scene::Round& round) { rounds.push_back(round); };
  const auto result = compact(layout.marker(), settings, run);
  ASSERT_TRUE(result);
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LT(result->length_after, 0.95 * static_cast<double>(result->length_before));
  ASSERT_EQ(rounds.size(), static_cast<std::size_t>(result->rounds));
  Coord last = result->length_before;
  for (std::size_t k = 0; k < rounds.size(); ++k) {
    EXPECT_EQ(rounds[k].number, static_cast<int>(k) + 1);
    EXPECT_LE(rounds[k].length, last);
    last = rounds[k].length;
  }
}

// The columns of the largest program before the first round is reported.
int columns_before_first_round(const Marker& marker, const CompactionSettings& settings) {
  SumCache sums;
  scene::Run run{sums};
  int columns = 0;
  bool reported = false;
  run.observer.on_program = [&](const lp::LinearProgram& program) {
    if (!reported) columns = std::max(columns, program.columns());
  };
  run.observer.on_round = [&](const scene::Round&) { reported = true; };
  EXPECT_TRUE(compact(marker, settings, run));
  return columns;
}

TEST(Compact, OfALongMarkerSolvesNoWholeProgramFirstWhenItsSectionsAreHard) {
  const Marker easy = test::tiled(test::garment("charlie_04g"), 240);
  const Marker hard = test::loosened(test::tiled(test::garment("jeans_02g"), 240), 0.03);
  CompactionSettings settings = kStandard;
  settings.sweeps = false;
  settings.tuning.sections.many = settings.tuning.sections.sampled = 200;
  settings.tuning.sections.pieces = 50;
  EXPECT_GT(columns_before_first_round(easy, settings), 300);
  EXPECT_LT(columns_before_first_round(hard, settings), 200);
  settings.tuning.sections.sampled = 1000;
  EXPECT_GT(columns_before_first_round(hard, settings), 300);
}

TEST(Compact, HandlesAPieceInsideTheBoxOfAnother) {
  // A frame open to the right holds a small square; both can move.
  Layout layout{1000};
  const auto cup =
      layout.shape_of({{0, 0}, {900, 0}, {900, 100}, {100, 100}, {100, 900}, {900, 900}, {900, 1000}, {0, 1000}});
  const auto square = layout.shape_of(test::rectangle(300, 300));
  layout.put(cup, {500, 0}).put(square, {900, 350});
  const auto result = compacted(layout.marker());
  EXPECT_EQ(result.length_after, 900);
}

// In a strip of 1000, the usual trust radius of 100 reaches 220 neighbours of each of these squares.
TEST(Compact, ModelsOnlyTheNearestOfManyTinyPieces) {
  constexpr int kColumns = 20;
  constexpr int kRows = 40;
  constexpr int kPieces = kColumns * kRows;
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(4, 4));
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) layout.put(square, {10 * column, 10 * row});
  }
  const auto length_with = [&](const CompactionSettings& settings) {
    SumCache sums;
    scene::Observer observer;
    int most_rows = 0;
    observer.on_program = [&](const lp::LinearProgram& program) { most_rows = std::max(most_rows, program.rows()); };
    const auto result = compact(layout.marker(), settings, {sums, {}, observer});
    EXPECT_TRUE(result && is_valid(result->marker));
    EXPECT_LE(most_rows, 4 * settings.tuning.most_near_pairs * kPieces);
    return result->length_after;
  };
  CompactionSettings more = kStandard;
  more.tuning.most_near_pairs = 32;
  EXPECT_EQ(length_with(more), 4 * kColumns);
  EXPECT_LT(length_with(kStandard), 4 * kColumns);  // squares move across, into the free rest of the strip
}

}  // namespace
}  // namespace selvage::motion::compaction
