#include "core/search/refine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"

namespace selvage::search {
namespace {

RefineSettings brief(std::uint64_t effort, bool tilts = false) {
  RefineSettings settings = refine_settings();
  settings.effort = effort;
  settings.tilts = tilts;
  settings.nests = false;
  return settings;
}
RefineSettings nesting(std::uint64_t effort) {
  RefineSettings settings = brief(effort);
  settings.nests = true;
  return settings;
}

motion::compaction::Compaction refined(const Marker& marker, const RefineSettings& settings) {
  SumCache sums;
  const auto result = refine(marker, settings, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before);
  EXPECT_EQ(result->length_after, length_of(result->marker));
  EXPECT_DOUBLE_EQ(result->utilisation_after, utilisation_of(result->marker));
  return *result;
}

Coord standard_length(const Marker& marker) {
  SumCache sums;
  return compact(marker, compaction_settings(motion::compaction::Accuracy::kStandard), {sums})->length_after;
}

TEST(Refine, IsNeverLongerThanStandard) {
  for (const unsigned seed : {3U, 7U, 21U}) {
    const Marker marker = test::loose_marker(seed);
    EXPECT_LE(refined(marker, brief(3'000)).length_after, standard_length(marker)) << seed;
  }
}

TEST(Refine, SwapsPiecesWhereCompactionCannot) {
  // Two tall bars, then two low ones: they fill the strip's width only in pairs of one tall and one low bar.
  test::Layout layout{1000};
  const auto tall = layout.shape_of(test::rectangle(300, 650));
  const auto low = layout.shape_of(test::rectangle(300, 350));
  layout.put(tall, {0, 0}).put(low, {0, 650});
  layout.put(tall, {300, 0}).put(tall, {600, 0}).put(low, {900, 0}).put(low, {900, 350});
  EXPECT_EQ(standard_length(layout.marker()), 1200);
  EXPECT_EQ(refined(layout.marker(), brief(20'000)).length_after, 900);
  RefineSettings settings = brief(20'000);
  settings.most_pieces_swapped = 6;
  EXPECT_EQ(refined(layout.marker(), settings).length_after, 900);
  settings.most_pieces_swapped = 5;
  EXPECT_EQ(refined(layout.marker(), settings).length_after, 1200);
}

// What a single seed finds in a short time is a matter of luck.
double mean_length(const Marker& marker, RefineSettings settings, std::uint32_t seeds) {
  double sum = 0;
  for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
    sum += static_cast<double>(refined(marker, settings).length_after);
  }
  return sum / seeds;
}

TEST(Refine, ShortensAGarmentMarkerBeyondStandard) {
  const Marker marker = test::garment("jeans_02g");
  const auto standard = static_cast<double>(standard_length(marker));
  EXPECT_LT(mean_length(marker, brief(20'000), 8), 0.995 * standard);
}

TEST(Refine, NestsPiecesAnew) {
  const Marker marker = test::garment("jeans_02g");
  EXPECT_LT(mean_length(marker, nesting(30'000), 3), 0.99 * mean_length(marker, brief(30'000), 3));
}

TEST(Refine, LeavesUnplacedPiecesUnplaced) {
  Marker marker = test::garment("jeans_02g");
  marker.unplaced.push_back(marker.pieces.back());
  marker.pieces.pop_back();
  const auto result = refined(marker, nesting(15'000));
  EXPECT_EQ(result.marker.unplaced, marker.unplaced);
  EXPECT_LT(result.length_after, standard_length(marker));
}

TEST(Refine, TiltsOnlyPiecesThatMayTilt) {
  Marker marker = test::garment("jeans_02g");
  const auto tilted = refined(marker, brief(0, true)).marker;
  const auto leans = [](const Piece& piece) { return piece.orientation.tilt != Angle{}; };
  EXPECT_TRUE(std::any_of(tilted.pieces.begin(), tilted.pieces.end(), leans));
  for (const Piece& piece : tilted.pieces) {
    EXPECT_LE(std::abs(piece.orientation.tilt.degrees), marker.shapes[piece.shape.value].tilt_limit.degrees);
  }
  for (Shape& shape : marker.shapes) shape.tilt_limit = {};
  const auto straight = refined(marker, brief(0, true)).marker;
  EXPECT_TRUE(std::none_of(straight.pieces.begin(), straight.pieces.end(), leans));
}

TEST(Refine, KeepsLocksGroupsAndRotations) {
  Marker marker = test::garment("jeans_02g");
  for (const std::size_t k : {3U, 11U}) marker.pieces[k].locked = true;
  for (const std::size_t k : {5U, 6U}) marker.pieces[k].group = "pair";
  RefineSettings settings = nesting(15'000);
  settings.tilts = true;
  const auto result = refined(marker, settings);
  for (const std::size_t k : {3U, 11U}) EXPECT_EQ(result.marker.pieces[k], marker.pieces[k]);
  EXPECT_EQ(result.marker.pieces[5].at - marker.pieces[5].at, result.marker.pieces[6].at - marker.pieces[6].at);
  for (const Piece& piece : result.marker.pieces) {
    const auto& allowed = marker.shapes[piece.shape.value].rotations;
    EXPECT_NE(std::find(allowed.begin(), allowed.end(), piece.orientation.rotation), allowed.end()) << piece.id;
  }
}

TEST(Refine, TurnsNoPieceWhoseTiltIsLocked) {
  Marker marker = test::garment("jeans_02g");
  const auto turned = [&](const Marker& now) {
    int count = 0;
    for (std::size_t k = 0; k < now.pieces.size(); ++k)
      count += now.pieces[k].orientation != marker.pieces[k].orientation;
    return count;
  };
  int some = 0;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {  // whether a single seed rotates a piece is a matter of luck
    RefineSettings settings = brief(20'000);
    settings.seed = seed;
    some += turned(refined(marker, settings).marker);
  }
  EXPECT_GT(some, 0);
  for (Piece& piece : marker.pieces) piece.locked.tilt = true;
  EXPECT_EQ(turned(refined(marker, brief(20'000, true)).marker), 0);
}

TEST(Refine, GivesTheSameAnswerWithAColdAndAWarmCache) {
  const Marker marker = test::garment("jeans_02g");
  SumCache warm;
  const auto first = refine(marker, brief(4'000), {warm});
  const auto second = refine(marker, brief(4'000), {warm});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->marker, second->marker);
  EXPECT_EQ(first->programs, second->programs);
}

TEST(Refine, ReturnsTheBestSoFarWhenCancelled) {
  const Marker marker = test::garment("jeans_02g");
  for (const int attempts : {1, 4, 9}) {
    std::stop_source source;
    SumCache sums;
    Coord seen = length_of(marker);
    scene::Observer observer;
    observer.on_round = [&](const scene::Round& round) {
      EXPECT_LE(round.length, seen);
      seen = round.length;
      if (round.number == attempts) source.request_stop();
    };
    const auto result = refine(marker, refine_settings(), {sums, source.get_token(), observer});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
    EXPECT_EQ(result->rounds, attempts);
    EXPECT_EQ(result->length_after, seen);
    EXPECT_TRUE(is_valid(result->marker));
  }
}

TEST(Refine, DoesNotChangeAMarkerOfLockedPieces) {
  Marker marker = test::loose_marker(7);
  for (Piece& piece : marker.pieces) piece.locked = true;
  EXPECT_EQ(refined(marker, refine_settings()).marker, marker);
}

}  // namespace
}  // namespace selvage::search
