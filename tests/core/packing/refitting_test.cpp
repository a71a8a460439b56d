// Filling gaps and exact compaction of windows.
#include <gtest/gtest.h>

#include <random>
#include <stop_token>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/packing/refitting/compact_exactly.h"
#include "core/packing/refitting/fill_gaps.h"
#include "core/packing/refitting/scatter.h"
#include "protocol/execution/thread_pool.h"
#include "tests/core/motion/markers.h"
#include "tests/laws/random_marker.h"

namespace selvage::packing::refitting {
namespace {

Coord standard_length(const Marker& marker) {
  SumCache sums;
  const auto settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  return compact(marker, settings, scene::Run{sums})->length_after;
}

// A hole between four blocks, which no piece reaches by sliding, and a small square at the end.
Marker with_hole() {
  test::Layout layout{50'000};
  const auto lying = layout.shape_of(test::rectangle(60'000, 20'000));
  const auto square = layout.shape_of(test::rectangle(9'000, 9'000));
  const auto post = layout.shape_of(test::rectangle(25'000, 10'000));
  layout.put(lying, {0, 0}).put(lying, {0, 30'000});
  layout.put(post, {0, 20'000}).put(post, {35'000, 20'000}).put(square, {60'000, 0});
  return layout.marker();
}

TEST(FillGaps, PutsASmallPieceIntoAHole) {
  Marker marker = with_hole();
  marker.pieces[3].locked = true;  // keeps the hole open
  SumCache sums;
  ASSERT_EQ(standard_length(marker), 69'000);
  GapSettings settings;
  settings.trials = 10;
  settings.tuning.small = 0.25;
  const auto filled = fill_gaps(marker, settings, scene::Run{sums});
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->length_after, 60'000);
  EXPECT_EQ(filled->length_after, length_of(filled->marker));
  EXPECT_EQ(filled->kept, 1U);
  EXPECT_TRUE(is_valid(filled->marker));
  EXPECT_EQ(filled->marker.pieces[3], marker.pieces[3]);
}

TEST(FillGaps, PlacesUnplacedPiecesWithinTheLength) {
  Marker marker = with_hole();
  marker.pieces[3].locked = true;
  marker.unplaced.push_back(marker.pieces[4]);
  marker.unplaced.push_back(marker.pieces[0]);
  marker.unplaced[1].id = "too large";
  for (Piece& piece : marker.unplaced) piece.at = {};
  marker.pieces.pop_back();
  SumCache sums;
  GapSettings settings;
  settings.trials = 0;
  const auto filled = fill_gaps(marker, settings, scene::Run{sums});
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->placed, 1U);
  ASSERT_EQ(filled->marker.unplaced.size(), 1U);
  EXPECT_EQ(filled->marker.unplaced[0].id, "too large");
  EXPECT_EQ(filled->length_after, 60'000);
  EXPECT_TRUE(is_valid(filled->marker));
}

TEST(FillGaps, LeavesLockedPiecesAndGroups) {
  Marker marker = with_hole();
  for (Piece& piece : marker.pieces) piece.group = "all";
  SumCache sums;
  const auto filled = fill_gaps(marker, {}, scene::Run{sums});
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->rounds, 0);
  EXPECT_EQ(filled->length_after, standard_length(marker));
}

TEST(FillGaps, RefusesMarkersThatCompactionRefuses) {
  test::Layout layout{50'000};
  const auto square = layout.shape_of(test::rectangle(9'000, 9'000));
  layout.put(square, {0, 0}).put(square, {1'000, 1'000});
  SumCache sums;
  const auto filled = fill_gaps(layout.marker(), {}, scene::Run{sums});
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, ErrorCode::kMarkerOverlaps);
}

TEST(FillGaps, ReturnsTheBestMarkerSoFarWhenCancelled) {
  SumCache sums;
  std::stop_source source;
  scene::Run run{sums, source.get_token()};
  run.observer.on_round = [&](const scene::Round& round) {
    if (round.number == 3) source.request_stop();
  };
  const auto filled = fill_gaps(test::loose_marker(5, 4, 3), {}, run);
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(filled->rounds, 3);
  EXPECT_TRUE(is_valid(filled->marker));
}

TEST(Scattered, SaysHowManyPiecesFoundRoom) {
  Marker marker = with_hole();
  Piece& square = marker.unplaced.emplace_back(marker.pieces[4]);
  square.id = "second square";
  SumCache sums;
  const auto placed_until = [&](Coord end) {
    std::mt19937_64 random{1};
    return scattered(marker, end, true, random, scene::Run{sums});
  };
  const Scattered one = placed_until(80'000);
  ASSERT_TRUE(one.layout);
  EXPECT_EQ(one.placed, 1U);
  EXPECT_TRUE(is_valid(*one.layout));
  // Two more squares: the hole has room for one.
  marker.unplaced.push_back(Piece{square});
  marker.unplaced[1].id = "third square";
  EXPECT_EQ(placed_until(60'000).placed, 1U);
  EXPECT_FALSE(placed_until(60'000).layout);
  marker.unplaced.front().shape = marker.unplaced.back().shape = marker.pieces[0].shape;
  EXPECT_EQ(placed_until(60'000).placed, 0U);
}

// Copies of a layout that compaction cannot shorten, one behind another: there is room for the low bars above the tall
// ones, but they cannot get there.
Marker bars(int times) {
  test::Layout layout{100'000};
  const auto tall = layout.shape_of(test::rectangle(30'000, 65'000));
  const auto low = layout.shape_of(test::rectangle(30'000, 35'000));
  const auto whole = layout.shape_of(test::rectangle(20'000, 100'000));
  for (Coord x = 0; x < 160'000 * times; x += 160'000) {
    layout.put(whole, {x, 0}).put(tall, {x + 20'000, 0}).put(low, {x + 20'000, 65'000});
    layout.put(tall, {x + 50'000, 0}).put(tall, {x + 80'000, 0});
    layout.put(low, {x + 110'000, 0}).put(low, {x + 110'000, 35'000}).put(whole, {x + 140'000, 0});
  }
  return layout.marker();
}

TEST(CompactExactly, PutsBarsWhereCompactionCannot) {
  const Marker marker = bars(1);
  ASSERT_EQ(standard_length(marker), 160'000);
  SumCache sums;
  const auto exact = compact_exactly(marker, {}, scene::Run{sums});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->length_after, 130'000);
  EXPECT_EQ(exact->reason, scene::StopReason::kConverged);
  EXPECT_TRUE(is_valid(exact->marker));
  // In a window of only one low bar, the other one blocks it.
  ExactCompactionSettings narrow;
  narrow.pieces = narrow.most_pieces = 1;
  EXPECT_EQ(compact_exactly(marker, narrow, scene::Run{sums})->length_after, 160'000);
}

TEST(CompactExactly, SearchesLongerWhenNoWindowGains) {
  const Marker marker = bars(1);
  SumCache sums;
  ExactCompactionSettings settings;
  settings.tuning.first_nodes = 1;
  settings.nodes = 1;
  const auto brief = compact_exactly(marker, settings, scene::Run{sums});
  ASSERT_TRUE(brief);
  EXPECT_EQ(brief->length_after, 160'000);
  EXPECT_EQ(brief->reason, scene::StopReason::kConverged);
  settings.nodes = 300;
  const auto longer = compact_exactly(marker, settings, scene::Run{sums});
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->length_after, 130'000);
  EXPECT_EQ(longer->reason, scene::StopReason::kConverged);
  EXPECT_GT(longer->windows, brief->windows);
  // The windows of all searches count.
  settings.windows = brief->windows;
  const auto stopped = compact_exactly(marker, settings, scene::Run{sums});
  EXPECT_EQ(stopped->reason, scene::StopReason::kWorkLimit);
  EXPECT_EQ(stopped->windows, brief->windows);
}

TEST(CompactExactly, SearchesOnlyWindowsOfTheGivenPieces) {
  const Marker marker = bars(2);
  SumCache sums;
  ASSERT_EQ(compact_exactly(marker, {}, scene::Run{sums})->length_after, 260'000);
  ExactCompactionSettings settings;
  settings.pieces = 5;
  settings.most_pieces = 5;
  settings.among = {PieceId{2}};  // a low bar of the first half
  const auto exact = compact_exactly(marker, settings, scene::Run{sums});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->length_after, 290'000);
  EXPECT_TRUE(is_valid(exact->marker));
  settings.among = std::vector<PieceId>{};
  EXPECT_EQ(compact_exactly(marker, settings, scene::Run{sums})->length_after, 320'000);
}

TEST(CompactExactly, MovesNothingBehindAWindowThatIsLocked) {
  Marker marker = with_hole();
  marker.pieces[4].locked = true;
  SumCache sums;
  const auto exact = compact_exactly(marker, {}, scene::Run{sums});
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->marker.pieces[4], marker.pieces[4]);
  EXPECT_EQ(exact->length_after, 69'000);
}

TEST(RefittingLaws, ThreadsDoNotMatterAndAnswersAreNeverLonger) {
  test::Random random{71};
  for (int trial = 0; trial < 2 / test::kSlowdown + 1; ++trial) {
    const Marker marker = test::random_marker(random);
    GapSettings filling;
    filling.trials = 6;
    ExactCompactionSettings windows;
    windows.pieces = 3;
    windows.nodes = 100;
    windows.windows = 6;
    const Coord standard = standard_length(marker);
    std::vector<Marker> answers[2];
    for (const std::size_t threads : {1U, 2U, 4U}) {
      const protocol::execution::ThreadPool pool{threads - 1};
      SumCache sums;
      scene::Run run{sums};
      run.executor = &pool;
      answers[0].push_back(fill_gaps(marker, filling, run)->marker);
      answers[1].push_back(compact_exactly(marker, windows, run)->marker);
    }
    for (const auto& same : answers) {
      EXPECT_EQ(same[1], same[0]) << "trial " << trial;
      EXPECT_EQ(same[2], same[0]) << "trial " << trial;
      EXPECT_TRUE(is_valid(same[0])) << "trial " << trial;
      EXPECT_LE(length_of(same[0]), standard) << "trial " << trial;
    }
  }
}

}  // namespace
}  // namespace selvage::packing::refitting
