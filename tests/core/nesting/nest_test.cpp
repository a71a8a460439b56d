// Tests of core/nesting/nest.h: its laws on random markers, and corner cases.
#include "core/nesting/nest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/nesting/nested.h"
#include "tests/core/nesting/unplaced_pieces.h"
#include "tests/laws/random_marker.h"
#include "tests/support/garment.h"

namespace selvage::nesting {
namespace {

using test::ids_of;
using test::kWidth;
using test::nested;
using test::Random;
using test::rectangle;
using test::settings_of;
using test::unplaced_pieces;

// Attempts are given up at once, so that the search walks (exploration.h).
NestSettings walking(NestSettings settings) {
  settings.tuning.bold_patience = 1;
  settings.tuning.search.patience = settings.tuning.search.strikes = 1;
  return settings;
}

// Every other trial walks.
NestSettings settings_of_trial(int trial, std::uint64_t moves) {
  return trial % 2 == 1 ? walking(settings_of(moves)) : settings_of(moves);
}

// A random marker, some of its pieces unplaced.
Marker partly_placed(Random& random) {
  Marker marker = test::random_marker(random);
  Marker rest = test::taken_off(marker);
  if (random.chance(50)) return rest;
  for (std::size_t k = rest.unplaced.size(); k-- > 0;) {
    if (random.chance(50)) continue;
    const auto was = std::find_if(marker.pieces.begin(), marker.pieces.end(),
                                  [&](const Piece& piece) { return piece.id == rest.unplaced[k].id; });
    rest.pieces.push_back(*was);
    rest.unplaced.erase(rest.unplaced.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return rest;
}

TEST(Nest, ItsAnswersAreValidAndComplete) {
  Random random{1};
  for (int trial = 0; trial < 60 / test::kSlowdown; ++trial) {
    const Marker marker = partly_placed(random);
    const Nesting nesting = nested(marker, settings_of_trial(trial, 150));
    EXPECT_TRUE(is_valid(nesting.marker)) << "trial " << trial;
    EXPECT_EQ(ids_of(nesting.marker), ids_of(marker)) << "trial " << trial;
    EXPECT_EQ(nesting.length_after, length_of(nesting.marker));
    EXPECT_EQ(nesting.left_over, nesting.marker.unplaced.size());
    EXPECT_EQ(nesting.marker.strip, marker.strip);
    EXPECT_TRUE(make_marker(nesting.marker)) << "trial " << trial;
    for (const Piece& piece : marker.pieces) {
      if (!piece.locked) continue;
      EXPECT_NE(std::find(nesting.marker.pieces.begin(), nesting.marker.pieces.end(), piece),
                nesting.marker.pieces.end())
          << "trial " << trial << ": a locked piece moved";
    }
  }
}

// Small rotations in the end may shorten the longer of two markers by more.
TEST(Nest, MoreMovesAreNeverWorseBeforeSmallRotations) {
  Random random{2};
  for (int trial = 0; trial < 12 / test::kSlowdown; ++trial) {
    Marker marker = partly_placed(random);
    marker.strip.longest.reset();
    Coord length = kLatticeLimit;
    for (const std::uint64_t moves : {0, 40, 90, 200, 400}) {
      NestSettings settings = settings_of_trial(trial, moves);
      settings.tilts = false;
      const Coord next = nested(marker, settings).length_after;
      EXPECT_LE(next, length) << "trial " << trial << ", " << moves << " moves";
      length = next;
    }
  }
}

TEST(Nest, IsTheSameOnAnyNumberOfThreads) {
  Random random{3};
  for (int trial = 0; trial < 5; ++trial) {
    const Marker marker = partly_placed(random);
    NestSettings settings = settings_of_trial(trial, 100);
    settings.searches = 3;
    const Nesting expected = nested(marker, settings);
    for (const std::size_t threads : {1U, 2U, 4U}) {
      const Nesting found = nested(marker, settings, protocol::execution::ThreadPool{threads - 1});
      EXPECT_EQ(found.marker, expected.marker) << "trial " << trial << ", " << threads << " threads";
      EXPECT_EQ(found.history, expected.history);
      EXPECT_EQ(found.moves, expected.moves);
      EXPECT_EQ(found.search, expected.search);
    }
  }
}

TEST(Nest, IsTheSameWhateverTheCacheHolds) {
  Random random{17};
  for (int trial = 0; trial < 4; ++trial) {
    const Marker marker = test::taken_off(test::random_marker(random));
    SumCache sums;
    const auto first = nest(marker, settings_of(300), {sums});
    const auto again = nest(marker, settings_of(300), {sums});
    ASSERT_TRUE(first && again);
    EXPECT_EQ(again->marker, first->marker) << "trial " << trial;
  }
}

TEST(Nest, IsNeverLongerThanAValidInput) {
  Random random{4};
  for (int trial = 0; trial < 20 / test::kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    EXPECT_LE(nested(marker, settings_of_trial(trial, 100)).length_after, length_of(marker)) << "trial " << trial;
  }
}

TEST(Nest, FillsAStripThatSquaresFillCompletely) {
  const Marker marker = unplaced_pieces({rectangle(250'000, 250'000)}, 16, kWidth);
  const Nesting nesting = nested(marker, settings_of(5'000));
  EXPECT_EQ(nesting.length_after, kWidth);
  EXPECT_EQ(nesting.reason, scene::StopReason::kConverged);
}

TEST(Nest, InterlocksTrianglesByHalfTurns) {
  // Two of them form a square, which requires rotation by 180 degrees.
  const Marker marker = unplaced_pieces({{{0, 0}, {500'000, 0}, {0, 500'000}}}, 8, kWidth);
  const Nesting nesting = nested(marker, settings_of(3'000));
  EXPECT_LE(nesting.length_after, kWidth + kWidth / 100);
}

TEST(Nest, AWalkAloneShortensAMarker) {
  const std::vector<Polygon> outlines{rectangle(200'000, 130'000), {{0, 0}, {310'000, 0}, {0, 170'000}}};
  NestSettings settings = walking(settings_of(3'000));
  settings.tuning.raced_moves = settings.moves;  // there is one start
  settings.tuning.least_step = settings.tuning.first_step;
  settings.tuning.explored = 1;
  const Nesting nesting = nested(unplaced_pieces(outlines, 20, kWidth), settings);
  ASSERT_GE(nesting.history.size(), 2U);
  EXPECT_LT(nesting.history.back().length, nesting.history.front().length);
}

TEST(Nest, AttemptsShortenAMarkerWhereWalksDoNot) {
  const std::vector<Polygon> outlines{rectangle(200'000, 130'000), {{0, 0}, {310'000, 0}, {0, 170'000}}};
  const Marker marker = unplaced_pieces(outlines, 20, kWidth);
  NestSettings settings = walking(settings_of(3'000));
  settings.tuning.raced_moves = settings.moves;  // there is one start
  settings.tuning.walk_slack = -0.5;             // there is no marker of half the length
  settings.tuning.first_step = settings.tuning.least_step;
  settings.tuning.explored = 1;
  const Nesting walked = nested(marker, settings);  // its first turn does not end
  settings.tuning.turn_moves = 100;
  const Nesting attempted = nested(marker, settings);
  EXPECT_LT(attempted.length_after, walked.length_after);
}

TEST(Nest, WithoutABudgetPlacesAllPieces) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(100'000, 400'000)}, 20, kWidth);
  const Nesting nesting = nested(marker, settings_of(0));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_TRUE(nesting.marker.unplaced.empty());
  EXPECT_EQ(nesting.reason, scene::StopReason::kWorkLimit);
  EXPECT_EQ(nesting.moves, 0u);
}

TEST(Nest, OfNoPiecesIsEmpty) {
  Marker marker = unplaced_pieces({rectangle(300'000, 200'000)}, 0, kWidth);
  SumCache sums;
  const auto empty = nest(marker, settings_of(100), {sums});
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, ErrorCode::kEmptyMarker);
  // All pieces are held.
  marker = unplaced_pieces({rectangle(300'000, 200'000)}, 1, kWidth);
  marker.pieces = std::move(marker.unplaced);
  marker.unplaced.clear();
  marker.pieces[0].locked = true;
  const Nesting held = nested(marker, settings_of(100));
  EXPECT_EQ(held.marker, marker);
}

TEST(Nest, NamesThePieceThatFitsInNoOrientation) {
  Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(1'100'000, 1'000'001)}, 4, kWidth);
  SumCache sums;
  const auto refused = nest(marker, settings_of(100), {sums});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kPieceTooWide);
  EXPECT_EQ(refused.error().field, "/unplaced/1");
}

TEST(Nest, OfAsManyPiecesAsAMarkerMayHaveIsValid) {
  const Marker marker = unplaced_pieces({rectangle(3'000, 2'000), rectangle(1'300, 4'100)}, 20'000, kWidth);
  const Nesting nesting = nested(marker, settings_of(0));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces.size(), 20'000u);
}

TEST(Nest, OfOneGiantAmongTinyPiecesIsValid) {
  Marker marker = unplaced_pieces({rectangle(10'000, 8'000)}, 300, kWidth);
  marker.shapes.push_back(marker.shapes[0]);
  marker.shapes[1].id = "giant";
  marker.shapes[1].outline = {{0, 0}, {900'000, 0}, {450'000, 300'000}, {0, 900'000}};
  marker.unplaced[0].shape = ShapeId{1};
  const Nesting nesting = nested(marker, settings_of(100));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces.size(), 300u);
  EXPECT_LE(nesting.length_after, 950'000);
}

TEST(Nest, ShortensAMarkerOfManyWidthsInFewMoves) {
  const Marker marker = test::garment("jeans_22g");
  SumCache sums;
  const auto standard = compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums});
  const Nesting nesting = nested(standard->marker, settings_of(6'000));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_LT(nesting.length_after, standard->length_after);
}

TEST(Nest, OfOutlinesWithTheMostVerticesIsValid) {
  Polygon gear;
  for (int k = 0; k < 2'000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 2'000;
    const double radius = 100'000 + (k % 2) * 2'000 + 10'000 * std::sin(5 * angle);
    gear.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  const Marker marker = unplaced_pieces({gear}, 6, kWidth);
  const Nesting nesting = nested(marker, settings_of(20));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces.size(), 6u);
}

TEST(Nest, EndsSoonAfterItsTimeLimit) {
  const Marker marker = unplaced_pieces({rectangle(30'000, 20'000), rectangle(13'000, 41'000)}, 400, kWidth);
  NestSettings settings = settings_of(1'000'000'000);
  int asked = 0;
  settings.elapsed = [&asked] { return ++asked < 500 ? 0.0 : 1.0; };  // a clock that counts its readings
  const Nesting nesting = nested(marker, settings);
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.reason, scene::StopReason::kWorkLimit);
  EXPECT_TRUE(nesting.out_of_time);
  EXPECT_LT(asked, 1'000);
}

TEST(Nest, KeepsTheBestWhenItIsCancelled) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(130'000, 410'000)}, 20, kWidth);
  std::stop_source stop;
  SumCache sums;
  scene::Run run{sums, stop.get_token()};
  Coord last = 0;
  run.observer.on_round = [&](const scene::Round& round) {
    last = round.length;
    if (round.number == 2) stop.request_stop();
  };
  const auto nesting = nest(marker, settings_of(1'000'000'000), run);
  ASSERT_TRUE(nesting);
  EXPECT_EQ(nesting->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(nesting->length_after, last);
  EXPECT_TRUE(is_valid(nesting->marker));
}

TEST(Nest, ReportsValidMarkersOfTheLengthsThatItTells) {
  const Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(130'000, 410'000)}, 20, kWidth);
  SumCache sums;
  scene::Run run{sums};
  int reported = 0;
  run.observer.on_round = [&](const scene::Round& round) {
    ++reported;
    ASSERT_TRUE(round.marker);
    EXPECT_TRUE(is_valid(*round.marker));
    EXPECT_EQ(length_of(*round.marker), round.length);
  };
  ASSERT_TRUE(nest(marker, settings_of(2'000), run));
  EXPECT_GT(reported, 1);
}

TEST(Nest, ListsPiecesForWhichTheClothHasNoRoom) {
  Marker marker = unplaced_pieces({rectangle(500'000, 500'000)}, 9, kWidth);
  marker.strip.longest = 1'200'000;
  const Nesting nesting = nested(marker, settings_of(500));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces.size(), 4u);
  EXPECT_EQ(nesting.left_over, 5u);
  EXPECT_EQ(nesting.marker.unplaced[0].at, Vec{});
}

TEST(Nest, ChoosesThePiecesThatFillACloth) {
  // Four large squares fill the cloth.  The strips, which come first in columns of boxes, do not.
  Marker marker = unplaced_pieces({rectangle(500'000, 500'000), rectangle(900'000, 260'000)}, 8, kWidth);
  marker.strip.longest = kWidth;
  NestSettings settings = settings_of(2'000);
  const Nesting nesting = nested(marker, settings);
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(utilisation_of(nesting.marker), 1.0);
  // The strips are chosen if they have a higher value.
  for (const Piece& piece : marker.unplaced) settings.values[piece.id] = piece.shape.value == 0 ? 1 : 10;
  const Nesting strips = nested(marker, settings);
  EXPECT_TRUE(is_valid(strips.marker));
  EXPECT_EQ(std::count_if(strips.marker.pieces.begin(), strips.marker.pieces.end(),
                          [](const Piece& piece) { return piece.shape.value == 1; }),
            3);
}

TEST(Nest, ChoosesTheMoreValuableOfEqualPieces) {
  // The cloth has room for one of the large squares or for the small one.
  Marker marker = unplaced_pieces({rectangle(900'000, 900'000), rectangle(200'000, 200'000)}, 3, kWidth);
  marker.strip.longest = kWidth;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    NestSettings settings = settings_of(1'000);
    settings.seed = seed;
    settings.values = {{"0", 1}, {"1", 50}, {"2", 100}};
    const Nesting nesting = nested(marker, settings);
    ASSERT_EQ(nesting.marker.pieces.size(), 1u);
    EXPECT_EQ(nesting.marker.pieces[0].id, "2") << "seed " << seed;
  }
}

TEST(Nest, PlacesNewPiecesBesidesThoseThatStay) {
  Marker marker = unplaced_pieces({rectangle(400'000, 400'000)}, 4, kWidth);
  marker.pieces = {marker.unplaced[0]};
  marker.pieces[0].at = {200'000, 300'000};
  marker.pieces[0].locked = true;
  marker.unplaced.erase(marker.unplaced.begin());
  const Nesting nesting = nested(marker, settings_of(500));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(nesting.marker.pieces[0], marker.pieces[0]);
  EXPECT_EQ(nesting.marker.pieces.size(), 4u);
}

TEST(Nest, RefusesPiecesThatMustStayButOverlap) {
  Marker marker = unplaced_pieces({rectangle(400'000, 400'000)}, 3, kWidth);
  marker.pieces = {marker.unplaced[0], marker.unplaced[1]};
  marker.unplaced.resize(1);
  marker.unplaced[0].id = "2";
  for (Piece& piece : marker.pieces) piece.locked = true;
  SumCache sums;
  const auto overlapping = nest(marker, settings_of(10), {sums});
  ASSERT_FALSE(overlapping);
  EXPECT_EQ(overlapping.error().code, ErrorCode::kMarkerOverlaps);
  marker.pieces[1].at = {0, 700'000};
  const auto outside = nest(marker, settings_of(10), {sums});
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ErrorCode::kOutsideStrip);
}

TEST(Nest, OfAPileOfPiecesMakesAMarker) {
  Marker marker = unplaced_pieces({rectangle(300'000, 200'000), rectangle(130'000, 410'000)}, 10, kWidth);
  marker.pieces = std::move(marker.unplaced);
  marker.unplaced.clear();
  const Nesting nesting = nested(marker, settings_of(300));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_EQ(ids_of(nesting.marker), ids_of(marker));
}

// A rectangle whose drafted outline is rotated.
Marker askew_rectangles(std::size_t pieces, const std::vector<Angle>& rotations) {
  Polygon outline = rectangle(900'000, 300'000);
  outline = geometry::turned(outline, Angle::of_degrees(10));
  Marker marker = unplaced_pieces({outline}, pieces, kWidth);
  marker.shapes[0].rotations = rotations;
  return marker;
}

TEST(Nest, PiecesThatMayTurnFreelyReachAnyRotation) {
  const Marker marker = askew_rectangles(3, {});
  const Nesting nesting = nested(marker, settings_of(400));
  EXPECT_TRUE(is_valid(nesting.marker));
  EXPECT_TRUE(make_marker(nesting.marker));
  EXPECT_LT(nesting.length_after, 902'000);  // upright, side by side
  EXPECT_EQ(nesting.marker.shapes, marker.shapes);
  for (const Piece& piece : nesting.marker.pieces) EXPECT_EQ(piece.orientation.tilt, Angle{});
  NestSettings rigid = settings_of(400);
  rigid.tilts = false;
  EXPECT_GT(nested(marker, rigid).length_after, 950'000);
}

TEST(Nest, PiecesAreTiltedWithinTheirLimitsAtTheEnd) {
  Marker marker = askew_rectangles(3, {{90}, {270}});
  const Coord rigid = nested(marker, settings_of(400)).length_after;
  marker.shapes[0].tilt_limit = Angle::of_degrees(4);
  const Nesting nesting = nested(marker, settings_of(400));
  EXPECT_TRUE(make_marker(nesting.marker));
  EXPECT_LT(nesting.length_after, rigid - 50'000);
  marker.unplaced[1].locked.tilt = true;
  const Nesting locked = nested(marker, settings_of(400));
  for (const Piece& piece : locked.marker.pieces) {
    EXPECT_LE(std::abs(piece.orientation.tilt.degrees), 4);
    if (piece.id == marker.unplaced[1].id) {
      EXPECT_EQ(piece.orientation.tilt, Angle{});
    }
  }
}

TEST(Nest, FindsRoomBeforeAPieceThatIsLockedFarAway) {
  Marker marker = unplaced_pieces({rectangle(15'000, 15'000)}, 12, kWidth);
  marker.pieces = {marker.unplaced.back()};
  marker.unplaced.pop_back();
  marker.pieces[0].at = {1'000'000 * kWidth, 0};
  marker.pieces[0].locked = true;
  const Nesting nesting = nested(marker, settings_of(100));
  EXPECT_TRUE(is_valid(nesting.marker));
  for (std::size_t i = 1; i < nesting.marker.pieces.size(); ++i) EXPECT_LT(nesting.marker.pieces[i].at.x, kWidth);
}

TEST(Nest, FromScratchIgnoresTheInputPositions) {
  Marker marker = unplaced_pieces({rectangle(400'000, 500'000)}, 4, kWidth);
  const Nesting first = nested(marker, settings_of(40));
  NestSettings scratch = settings_of(40);
  scratch.from_scratch = true;
  Marker moved = first.marker;
  moved.pieces[3].locked = true;
  moved.pieces[3].at.x += 5'000'000;
  const Nesting again = nested(moved, scratch);
  EXPECT_EQ(ids_of(again.marker), ids_of(moved));
  const auto locked = std::find_if(again.marker.pieces.begin(), again.marker.pieces.end(),
                                   [](const Piece& piece) { return static_cast<bool>(piece.locked); });
  ASSERT_NE(locked, again.marker.pieces.end());
  EXPECT_EQ(locked->at, moved.pieces[3].at);
  // Without locks the answer is that of the pieces alone.
  EXPECT_EQ(nested(first.marker, scratch).length_after, first.length_after);
}

}  // namespace
}  // namespace selvage::nesting
