#include "core/motion/separation/separate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"
#include "tests/support/random.h"

namespace selvage::motion::separation {
namespace {

using test::Layout;

Separation separated(const Marker& marker, const SeparationSettings& settings = {}) {
  SumCache sums;
  const auto result = separate(marker, settings, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_EQ(result->apart, is_valid(result->marker));
  EXPECT_EQ(result->apart, result->remaining.empty());
  return *result;
}

// Two squares of size 200 that overlap by `depth`, in a strip where the first cannot move farther left.
Marker two_squares(Coord depth) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(200, 200));
  layout.put(square, {0, 400}).put(square, {200 - depth, 420}).put(square, {800, 0});
  return layout.marker();
}

// Of 1,500 pieces at one position, 1,124,250 pairs overlap.
TEST(Separate, RefusesHeaps) {
  Layout layout{1'000'000};
  const auto square = layout.shape_of(test::rectangle(200'000, 200'000));
  for (int k = 0; k < 1'500; ++k) layout.put(square, {0, 0});
  SumCache sums;
  const auto heap = separate(layout.marker(), {}, {sums});
  ASSERT_FALSE(heap);
  EXPECT_EQ(heap.error().code, ErrorCode::kMarkerOverlaps);
  EXPECT_EQ(heap.error().field, "/pieces");
  EXPECT_TRUE(heap.error().message.starts_with("at least 1000000 pairs")) << heap.error().message;
}

TEST(Separate, DoesNotChangeAValidMarker) {
  const Marker start = two_squares(0);
  const auto result = separated(start);
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.marker, start);
  EXPECT_EQ(result.programs, 0);
  EXPECT_EQ(result.moved, 0);
}

TEST(Separate, SeparatesTwoSquaresByExactlyTheirDepth) {
  for (const repair::TargetRule rule : {repair::TargetRule::kNearest, repair::TargetRule::kKernelRay}) {
    for (const Coord depth : {Coord{1}, Coord{30}, Coord{99}}) {
      const auto result = separated(two_squares(depth), {.target = rule});
      EXPECT_TRUE(result.apart);
      EXPECT_EQ(result.moved, static_cast<double>(depth));
      EXPECT_EQ(result.farthest_move, depth);
      EXPECT_EQ(result.length_after, result.length_before);
      EXPECT_EQ(result.marker.pieces[2].at, (Vec{800, 0}));
    }
  }
}

TEST(Separate, SeparatesAStackThatJustFits) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(250, 250));
  layout.put(square, {0, 10}).put(square, {0, 240}).put(square, {0, 510}).put(square, {0, 745});
  const auto result = separated(layout.marker());
  EXPECT_TRUE(result.apart);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(result.marker.pieces[k].at, (Vec{0, 250 * static_cast<Coord>(k)}));
  EXPECT_EQ(result.moved, 10 + 10 + 10 + 5);
}

TEST(Separate, MovesTheOnePieceThatCan) {
  Layout layout{300};
  const auto tall = layout.shape_of(test::rectangle(100, 300));
  layout.put(tall, {0, 0}, 0, true).put(tall, {80, 0}).put(tall, {250, 0}, 0, true);
  const auto result = separated(layout.marker());
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.marker.pieces[0].at, (Vec{0, 0}));
  EXPECT_EQ(result.marker.pieces[1].at, (Vec{100, 0}));
  EXPECT_EQ(result.marker.pieces[2].at, (Vec{250, 0}));
}

TEST(Separate, ObeysTheSpacing) {
  Marker start = two_squares(0);
  start.spacing = 15;
  const auto result = separated(start);
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.moved, 15);
}

TEST(Separate, LeavesTheAllowedOverlap) {
  Marker start = two_squares(10);
  EXPECT_EQ(separated(start).moved, 10);
  start.overlap = 4;
  EXPECT_EQ(separated(start).moved, 6);
  start.overlap = 10;
  EXPECT_EQ(separated(start).moved, 0);
}

TEST(Separate, PutsPiecesBackIntoTheStrip) {
  Marker start = two_squares(0);
  start.pieces[0].at = {-20, 400};
  start.pieces[2].at = {800, -130};
  const auto result = separated(start);
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.moved, 150);
}

// Three squares side by side across a strip that holds two and a half.
Marker overfull() {
  Layout layout{500};
  const auto square = layout.shape_of(test::rectangle(200, 200));
  layout.put(square, {0, 0}).put(square, {0, 150}).put(square, {0, 300});
  return layout.marker();
}

TEST(Separate, LengthensTheMarkerIfAllowed) {
  const auto held = separated(overfull());
  EXPECT_FALSE(held.apart);
  EXPECT_LE(held.length_after, held.length_before);
  const auto grown = separated(overfull(), {.grow = 1});
  EXPECT_TRUE(grown.apart);
  EXPECT_EQ(grown.length_after, 400);
}

TEST(Separate, ReportsRemainingOverlaps) {
  const auto result = separated(overfull());
  ASSERT_FALSE(result.apart);
  double depth = 0;
  for (const marker::Overlap& overlap : result.remaining) depth += overlap.depth;
  EXPECT_NEAR(depth, 100, 1e-6);  // 600 into 500
}

TEST(Separate, GivesUpEarlyWhenTooMuchOverlapIsLeft) {
  SeparationSettings settings;
  const int patient = separated(overfull(), settings).rounds;
  settings.tuning.hopeless = 0.01;
  const auto result = separated(overfull(), settings);
  EXPECT_FALSE(result.apart);
  EXPECT_EQ(result.rounds, settings.tuning.hopeless_after);
  EXPECT_LT(result.rounds, patient);
}

TEST(Separate, LockedPiecesThatOverlapRemain) {
  Marker start = two_squares(30);
  start.pieces[0].locked = start.pieces[1].locked = true;
  const auto result = separated(start);
  EXPECT_FALSE(result.apart);
  ASSERT_EQ(result.remaining.size(), 1U);
  EXPECT_EQ(result.remaining[0].first, PieceId{0});
  EXPECT_EQ(result.remaining[0].second, PieceId{1});
  EXPECT_NEAR(result.remaining[0].depth, 30, 1e-6);
  EXPECT_EQ(result.marker, start);
}

TEST(Separate, PopsOutPiecesThatBlockTheSeparation) {
  const auto result = separated(overfull(), {.pop_out = true});
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.popped.size(), 1U);
  EXPECT_EQ(result.marker.pieces.size(), 2U);
  Marker locked = two_squares(30);
  locked.pieces[0].locked = true;
  locked.strip.longest = 320;  // what extends beyond the strip blocks, too
  const auto kept = separated(locked, {.pop_out = true});
  EXPECT_TRUE(kept.apart);
  EXPECT_EQ(kept.marker.pieces[0], locked.pieces[0]);
}

TEST(Separate, PopsNeitherZonesNorTheLastPiece) {
  Marker on_flaw = two_squares(100);
  on_flaw.pieces[0].rules.zone = true;
  on_flaw.pieces[0].locked = true;
  on_flaw.pieces[1].locked = true;
  const auto result = separated(on_flaw, {.pop_out = true});
  EXPECT_TRUE(result.apart);
  ASSERT_EQ(result.marker.pieces.size(), 2U);
  EXPECT_TRUE(result.marker.pieces[0].rules.zone);
  on_flaw.pieces.pop_back();
  const auto alone = separated(on_flaw, {.pop_out = true});
  EXPECT_FALSE(alone.apart);
  EXPECT_EQ(alone.marker.pieces.size(), 2U);
}

TEST(Separate, GivesUpWhenMorePiecesWouldHaveToGo) {
  Marker start = overfull();
  for (std::uint32_t k = 0; k < 3; ++k) {  // a second column as full as the first
    Piece piece = start.pieces[k];
    piece.id += "+";
    piece.at.x += 200;
    start.pieces.push_back(piece);
  }
  for (const std::size_t most : {std::size_t{0}, std::size_t{1}}) {
    const auto result = separated(start, {.pop_out = true, .most_popped = most});
    EXPECT_FALSE(result.apart);
    EXPECT_TRUE(result.popped.empty());
  }
  const auto result = separated(start, {.pop_out = true, .most_popped = 2});
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.popped.size(), 2U);
}

TEST(Separate, RepairsWhatOnlyRoundingHasLeft) {
  test::Layout layout{50'000};
  const auto square = layout.shape_of(test::rectangle(20'000, 20'000));
  layout.put(square, {0, 0}).put(square, {19'998, 0}).put(square, {39'997, 0});
  const auto result = separated(layout.marker(), {.grow = 0.001});
  EXPECT_TRUE(result.apart);
  EXPECT_EQ(result.rounds, 0);
  EXPECT_EQ(result.length_after, 60'000);
}

// Two blocks and a trim between them are higher than the strip, and so are the blocks without the trim.
TEST(Separate, PopsSmallPiecesFirst) {
  test::Layout layout{500};
  const auto block = layout.shape_of(test::rectangle(400, 300));
  const auto trim = layout.shape_of(test::rectangle(60, 50));
  layout.put(block, {0, 0}).put(block, {0, 200}).put(trim, {170, 225});
  const auto result = separated(layout.marker(), {.pop_out = true, .small = 60 * 50});
  EXPECT_TRUE(result.apart);
  ASSERT_EQ(result.popped.size(), 2U);
  EXPECT_EQ(result.popped.front(), PieceId{2});
}

TEST(Separate, RefusesAPieceLockedOutside) {
  Marker start = two_squares(30);
  start.pieces[1].locked = true;
  start.pieces[1].at.y = -1;
  SumCache sums;
  const auto result = separate(start, {}, {sums});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kOutsideStrip);
  EXPECT_EQ(result.error().field, "/pieces/1/at");
  EXPECT_EQ(separate(two_squares(30), {.grow = -0.1}, {sums}).error().code, ErrorCode::kOutOfRange);
}

TEST(Separate, ReturnsTheLeastOverlapSoFarWhenCancelled) {
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  const auto result = separate(two_squares(30), {}, {sums, source.get_token()});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
  EXPECT_FALSE(result->apart);
  EXPECT_EQ(result->marker, two_squares(30));
  ASSERT_EQ(result->remaining.size(), 1U);  // reported, but not measured
  EXPECT_EQ(result->remaining[0].depth, 0);
}

// A pile that takes several rounds, cancelled whenever something is proved.
TEST(Separate, ClaimsOnlyWhatItHasProvedWhenCancelled) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(250, 250));
  for (Coord k = 0; k < 12; ++k) layout.put(square, {20 * k, 30 * k});
  const Marker start = layout.marker();
  SumCache sums;
  const auto depth = [&](const Marker& marker) {
    double sum = 0;
    for (const marker::Overlap& overlap : check(marker, sums).overlaps) sum += overlap.depth;
    return sum;
  };
  bool ended = false;
  for (int stop_at = 1; stop_at < 200 && !ended; ++stop_at) {
    std::stop_source source;
    scene::Observer observer;
    int proofs = 0;
    observer.on_stage = [&](scene::Stage stage) {
      if (stage == scene::Stage::kVerify && ++proofs == stop_at) source.request_stop();
    };
    const auto result = separate(start, {.grow = 10}, {sums, source.get_token(), observer});
    ASSERT_TRUE(result);
    ended = proofs < stop_at;
    EXPECT_EQ(result->apart, result->remaining.empty()) << stop_at;
    EXPECT_TRUE(!result->apart || is_valid(result->marker)) << stop_at;
    EXPECT_TRUE(result->apart || result->reason == scene::StopReason::kCancelled) << stop_at;
    EXPECT_LE(depth(result->marker), depth(start) * (1 + 1e-9)) << stop_at;
  }
  EXPECT_TRUE(ended);
}

// Two squares in a strip of their width, which are separate only while one of them extends beyond the strip.  If the
// motion is cancelled then, it returns the input and reports that the squares overlap.
TEST(Separate, CancelledBetweenRoundsReportsOnTheMarkerItReturns) {
  Layout narrow{200};
  const auto square = narrow.shape_of(test::rectangle(200, 200));
  narrow.put(square, {0, 0}).put(square, {170, 0});
  SumCache sums;
  for (const Marker& start : {narrow.marker(), overfull(), two_squares(30)}) {
    bool ended = false;
    for (int stop_at = 1; stop_at < 200 && !ended; ++stop_at) {
      std::stop_source source;
      scene::Observer observer;
      int rounds = 0;
      observer.on_round = [&](const scene::Round&) {
        if (++rounds == stop_at) source.request_stop();
      };
      const auto result = separate(start, {}, {sums, source.get_token(), observer});
      ASSERT_TRUE(result);
      ended = rounds < stop_at;
      EXPECT_EQ(result->apart, is_valid(result->marker)) << stop_at;
      EXPECT_EQ(result->apart, result->remaining.empty()) << stop_at;
      EXPECT_TRUE(ended || result->apart || result->reason == scene::StopReason::kCancelled) << stop_at;
    }
    EXPECT_TRUE(ended);
  }
}

// Forty pieces on a strip that holds hardly more than their area, many of them on top of others.
Marker crowded() {
  Layout layout{100'000};
  const auto bar = layout.shape_of(test::rectangle(18'000, 12'000));
  const auto wedge = layout.shape_of({{0, 0}, {20'000, 0}, {0, 15'000}});
  test::Random random{5};
  for (int k = 0; k < 40; ++k) layout.put(k % 2 == 0 ? bar : wedge, random.point(0, 80'000));
  return layout.marker();
}

// In the rounds of a crowded strip the marker is too long, so its pieces are put back into the length at the end.  A
// separation that is stopped then still returns what its rounds have gained.
TEST(Separate, KeepsWhatItsRoundsGainedWhenCancelled) {
  const Marker start = crowded();
  SumCache sums;
  for (const int stop_at : {2, 4, 6}) {
    std::stop_source source;
    scene::Observer observer;
    Coord longest = 0;
    observer.on_round = [&](const scene::Round& round) {
      longest = std::max(longest, round.length);
      if (round.number == stop_at) source.request_stop();
    };
    const auto stopped = separate(start, {}, {sums, source.get_token(), observer});
    ASSERT_TRUE(stopped);
    EXPECT_GT(longest, stopped->length_before);
    EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
    EXPECT_EQ(stopped->marker, separated(start, {.rounds = stop_at}).marker) << stop_at;
    EXPECT_GT(stopped->moved, 0) << stop_at;
    EXPECT_LE(stopped->length_after, stopped->length_before);
  }
}

// A loose marker, compacted and then perturbed.
Marker shaken_marker() {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  Marker marker = test::loose_marker(seed, *rc::gen::inRange(1, 5), *rc::gen::inRange(1, 4));
  SumCache sums;
  const auto tight = compact(marker, compaction_settings(compaction::Accuracy::kDraft), {sums});
  RC_ASSERT(static_cast<bool>(tight));
  marker = tight->marker;
  const auto most = *rc::gen::element<std::uint32_t>(1, 100, 2'000, 20'000, 100'000);
  std::mt19937 random{seed};
  const auto every = *rc::gen::inRange<std::size_t>(2, 9);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    Piece& piece = marker.pieces[k];
    piece.locked = k % every == 1;
    if (piece.locked) continue;
    piece.at.x += static_cast<Coord>(random() % (2 * most + 1)) - most;
    piece.at.y += static_cast<Coord>(random() % (2 * most + 1)) - most;
  }
  return marker;
}

RC_GTEST_PROP(SeparateLaws, ValidWhenApartLocksHoldLengthKept, ()) {
  Marker marker = shaken_marker();
  marker.spacing = *rc::gen::element<Coord>(0, 0, 500);
  const SeparationSettings settings{
      .rounds = 20,
      .grow = *rc::gen::element(0.0, 0.02, 0.5),
      .target = *rc::gen::element(repair::TargetRule::kNearest, repair::TargetRule::kKernelRay),
      .pop_out = *rc::gen::element(false, true)};
  SumCache sums;
  const auto result = separate(marker, settings, {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(result->apart == is_valid(result->marker));
  if (settings.pop_out) RC_ASSERT(result->apart);
  RC_ASSERT(static_cast<double>(result->length_after) <=
            (1 + settings.grow) * static_cast<double>(result->length_before));
  RC_ASSERT(result->length_after == length_of(result->marker));
  RC_ASSERT(result->marker.pieces.size() + result->popped.size() == marker.pieces.size());
  for (const Piece& piece : result->marker.pieces) {
    const auto before =
        std::find_if(marker.pieces.begin(), marker.pieces.end(), [&](const Piece& p) { return p.id == piece.id; });
    RC_ASSERT(before != marker.pieces.end());
    if (piece.locked) RC_ASSERT(piece == *before);
  }
  SumCache others;
  const auto again = separate(marker, settings, {others});
  RC_ASSERT(again->marker == result->marker);
  RC_ASSERT(again->popped == result->popped);
}

RC_GTEST_PROP(SeparateLaws, NeverWorse, ()) {
  Marker marker = shaken_marker();
  for (Piece& piece : marker.pieces) {
    piece.at.y = std::clamp(piece.at.y, Coord{100'000}, marker.strip.width - 100'000);
    piece.at.x = std::max(piece.at.x, Coord{100'000});
  }
  SumCache sums;
  const auto depth = [&](const Marker& m) {
    double sum = 0;
    for (const marker::Overlap& overlap : check(m, sums).overlaps) sum += overlap.depth;
    return sum;
  };
  const auto result = separate(marker, {.rounds = *rc::gen::inRange(0, 4)}, {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(depth(result->marker) <= depth(marker) * (1 + 1e-9));
  if (is_valid(marker)) RC_ASSERT(result->marker == marker);
}

}  // namespace
}  // namespace selvage::motion::separation
