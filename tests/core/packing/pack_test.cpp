#include "core/packing/pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/marker/validity.h"
#include "core/packing/first_layout.h"
#include "tests/core/motion/markers.h"
#include "tests/core/packing/optimum.h"
#include "tests/core/packing/polyominoes.h"

namespace selvage::packing {
namespace {

using test::expect_optimum;
using test::packed;

Marker limited(Marker marker, Coord longest) {
  marker.strip.longest = longest;
  return marker;
}

TEST(Pack, ExchangesBarsThatCompactionCannot) {
  test::Layout layout{100'000};
  const auto tall = layout.shape_of(test::rectangle(30'000, 65'000));
  const auto low = layout.shape_of(test::rectangle(30'000, 35'000));
  layout.put(tall, {0, 0}).put(low, {0, 65'000});
  layout.put(tall, {30'000, 0}).put(tall, {60'000, 0}).put(low, {90'000, 0}).put(low, {90'000, 35'000});
  expect_optimum(layout.marker(), 90'000);
}

// [Li94 8.1]: rectangles of height 1 and lengths a_i can fill two rows of equal length exactly when PARTITION has a
// solution.
TEST(Pack, SolvesPartition) {
  const auto optimum_of = [](const std::vector<Coord>& lengths, Coord optimum) {
    test::Layout layout{20'000};
    for (const Coord length : lengths) layout.put(layout.shape_of(test::rectangle(length * 1000, 10'000)), {0, 0});
    expect_optimum(layout.marker(), optimum * 1000);
  };
  optimum_of({3, 1, 1, 2, 2, 1}, 5);
  optimum_of({7, 5, 4, 3, 1}, 10);
  optimum_of({7, 7, 5, 1}, 12);  // 20 in all, but no two sets of 10
}

// [Li94 figure 8.1]: two long pieces side by side, which only fit one above the other after passing a corner.
TEST(Pack, StacksWhereCompactionKeepsPiecesInARow) {
  test::Layout layout{20'000};
  const auto bar = layout.shape_of(test::rectangle(50'000, 10'000));
  layout.put(bar, {0, 0}).put(bar, {50'000, 0});
  expect_optimum(layout.marker(), 50'000);
}

TEST(Pack, FindsFitsWithoutSlack) {
  test::Layout layout{40'000};
  const auto chevron = layout.shape_of(test::chevron(60'000, 10'000, 10'000));
  layout.put(chevron, {0, 0}).put(chevron, {70'000, 0}).put(chevron, {140'000, 0});
  expect_optimum(layout.marker(), 60'000);
}

TEST(Pack, PutsPiecesIntoNotches) {
  test::Layout layout{30'000};
  const auto u = layout.shape_of({{0, 0},
                                  {30'000, 0},
                                  {30'000, 10'000},
                                  {10'000, 10'000},
                                  {10'000, 20'000},
                                  {30'000, 20'000},
                                  {30'000, 30'000},
                                  {0, 30'000}});
  const auto bar = layout.shape_of(test::rectangle(20'000, 10'000));
  layout.put(u, {0, 0}).put(bar, {50'000, 0});
  expect_optimum(layout.marker(), 30'000);
}

TEST(Pack, TurnsPiecesOnlyWhereAllowed) {
  test::Layout layout{20'000};
  const auto upright = layout.shape_of(test::rectangle(10'000, 20'000));
  const auto lying = layout.shape_of(test::rectangle(20'000, 10'000));
  layout.put(upright, {0, 0}).put(lying, {20'000, 0}).put(lying, {50'000, 0});
  Marker marker = layout.marker();
  for (Shape& shape : marker.shapes) shape.rotations = {Angle{}};
  expect_optimum(marker, 30'000);
  // An isosceles triangle and its half turn interlock.
  test::Layout triangles{10'000};
  const auto triangle = triangles.shape_of({{0, 0}, {20'000, 0}, {10'000, 10'000}});
  triangles.put(triangle, {0, 0}).put(triangle, {30'000, 0});
  Marker turning = triangles.marker();
  turning.shapes[0].rotations = {Angle{}, Angle::of_degrees(180)};
  expect_optimum(turning, 30'000);
  PackSettings fixed;
  fixed.turns = false;
  expect_optimum(turning, 40'000, fixed);
}

TEST(Pack, KeepsTheSpacing) {
  test::Layout layout{21'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {0, 0}).put(square, {20'000, 0}).put(square, {40'000, 0}).put(square, {60'000, 0}).spaced(1000);
  expect_optimum(layout.marker(), 21'000);
}

TEST(Pack, KeepsLockedPiecesAndGroups) {
  test::Layout layout{20'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {10'000, 0}, 0, true).put(square, {60'000, 0}).put(square, {80'000, 10'000});
  Marker marker = layout.marker();
  marker.pieces[1].group = marker.pieces[2].group = "pair";
  const Packing packing = packed(marker);
  EXPECT_TRUE(packing.proved);
  EXPECT_EQ(packing.marker.pieces[0], marker.pieces[0]);
  EXPECT_EQ(packing.marker.pieces[2].at - packing.marker.pieces[1].at, (Vec{20'000, 10'000}));
  EXPECT_EQ(packing.length_after, 30'000);  // on both sides of the locked square
}

TEST(Pack, ProvesThatTheClothIsTooShort) {
  test::Layout layout{20'000};
  const auto square = layout.shape_of(test::rectangle(11'000, 11'000));
  layout.put(square, {0, 0}).put(square, {20'000, 0}).put(square, {40'000, 0});
  const Packing short_of = packed(limited(layout.marker(), 32'999));
  EXPECT_FALSE(short_of.found);
  EXPECT_TRUE(short_of.proved);
  expect_optimum(limited(layout.marker(), 33'000), 33'000);
}

TEST(Pack, PlacesUnplacedPieces) {
  test::Layout layout{20'000};
  const auto square = layout.shape_of(test::rectangle(10'000, 10'000));
  layout.put(square, {10'000, 0}, 0, true).put(square, {0, 0}).put(square, {0, 0}).put(square, {0, 0});
  Marker marker = layout.marker();
  // Locks and groups of unplaced pieces do not restrict their positions, and are kept.
  marker.pieces[2].locked = Locks{true, true, false};
  marker.pieces[2].group = marker.pieces[3].group = "pair";
  marker.unplaced.assign(marker.pieces.begin() + 2, marker.pieces.end());
  marker.pieces.resize(2);
  const Packing packing = packed(marker);
  EXPECT_TRUE(packing.proved);
  ASSERT_EQ(packing.marker.pieces.size(), 4U);
  EXPECT_TRUE(packing.marker.unplaced.empty());
  EXPECT_EQ(packing.length_before, 20'000);
  EXPECT_EQ(packing.length_after, 20'000);
  EXPECT_EQ(packing.marker.pieces[2].locked, marker.unplaced[0].locked);
  EXPECT_EQ(packing.marker.pieces[3].group, "pair");
  const Packing impossible = packed(limited(marker, 19'000));
  EXPECT_FALSE(impossible.found);
  EXPECT_TRUE(impossible.proved);
  EXPECT_EQ(impossible.marker, limited(marker, 19'000));
}

// Turned by 45 degrees and rounded to the lattice, a square of 10 units has an area of 98.
TEST(Pack, BoundsTheLengthByTheLeastAreaOfEachPiece) {
  test::Layout layout{18};
  const auto square = layout.shape_of(test::rectangle(10, 10));
  layout.put(square, {0, 0}).put(square, {30, 0});
  Marker marker = layout.marker();
  marker.shapes[0].rotations = {{0}, {45}};
  SumCache sums;
  PackSettings settings;
  settings.limits.nodes = 0;
  EXPECT_EQ(pack(marker, settings, {sums}).bound, 10) << "196 / 18, not 200 / 18";
}

TEST(Pack, SearchesNothingWithTooManyPieces) {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(1'000, 1'000));
  for (int k = 0; k < 65; ++k) layout.put(square, {k * 1'000, 0});
  const Packing packing = packed(layout.marker());
  EXPECT_EQ(packing.reason, scene::StopReason::kWorkLimit);
  EXPECT_TRUE(packing.found);
  EXPECT_FALSE(packing.proved);
  EXPECT_EQ(packing.work.nodes, 0U);
}

TEST(Pack, HoldsItsBestAnswerAtTheWorkLimit) {
  const Marker marker = test::loose_marker(3, 3, 2);
  PackSettings settings;
  settings.limits.nodes = 40;
  const Packing packing = packed(marker, settings);
  EXPECT_EQ(packing.reason, scene::StopReason::kWorkLimit);
  EXPECT_TRUE(packing.found);
  EXPECT_FALSE(packing.proved);
  EXPECT_LE(packing.length_after, packing.length_before);
  EXPECT_GT(packing.bound, 0);
  EXPECT_LT(packing.work.nodes, 400U);
}

// A search that is far from its end returns the layout of a short nesting, not pieces in a row.
TEST(Pack, NestsInstancesThatItCannotFinishSoon) {
  test::Random random{4};
  std::vector<test::Squares> pieces;
  while (pieces.size() < 16) {
    auto squares = test::random_squares(random, 5);
    if (box_of(squares).high.y < 4) pieces.push_back(std::move(squares));
  }
  const Marker marker = test::marker_of(pieces, 7);
  SumCache sums;
  const auto first = first_layout(marker, {sums});
  PackSettings settings;
  settings.limits.nodes = 6'000;
  const Packing packing = packed(marker, settings);
  EXPECT_FALSE(packing.proved);
  EXPECT_TRUE(is_valid(packing.marker));
  EXPECT_LT(packing.length_after, length_of(*first) - test::kSquare);
  EXPECT_LE(packing.bound, packing.length_after);
}

// Spacings are searched a little too narrow, so the search ends without a proof, and its layout is not the shortest.
TEST(Pack, CompactsWhatItCannotProve) {
  test::Layout layout{100'000'000};
  const auto square = layout.shape_of(test::rectangle(41'000'000, 41'000'000));
  layout.put(square, {0, 0}).put(square, {61'000'000, 0}).spaced(20'000'000);
  const Packing packing = packed(layout.marker());
  EXPECT_EQ(packing.reason, scene::StopReason::kConverged);
  EXPECT_FALSE(packing.proved);
  EXPECT_TRUE(is_valid(packing.marker));
  // At 59 mm of the strip's 100 across, the corners are 20 mm apart.
  const double along = std::sqrt(20.0 * 20.0 - 18.0 * 18.0);
  EXPECT_NEAR(static_cast<double>(packing.length_after), (82 + along) * 1e6, 100);
  EXPECT_LT(packing.bound, packing.length_after);
  EXPECT_GT(packing.bound, 90'000'000);
}

TEST(Pack, UsesOverlapAllowancesWithoutProvingAnything) {
  test::Layout layout{100'000};
  const auto square = layout.shape_of(test::rectangle(51'000, 51'000));
  layout.put(square, {0, 0}).put(square, {51'000, 0});
  Marker marker = layout.marker();
  marker.overlap = 2'400;
  for (Shape& shape : marker.shapes) shape.rotations = {Angle{}};
  for (const bool placed : {true, false}) {
    if (!placed) marker.unplaced = std::exchange(marker.pieces, {});
    const Packing packing = packed(marker);
    EXPECT_TRUE(packing.found);
    EXPECT_TRUE(is_valid(packing.marker));
    EXPECT_EQ(packing.length_after, 51'000);
    EXPECT_EQ(packing.marker.overlap, 2'400);
    EXPECT_FALSE(packing.proved);
    EXPECT_EQ(packing.bound, 0);
    EXPECT_EQ(packing.reason, scene::StopReason::kWorkLimit);
  }
}

TEST(Pack, ReportsABoundThatRisesAndTheNodesSoFar) {
  const Marker marker = test::loose_marker(5, 3, 2);
  SumCache sums;
  scene::Run run{sums};
  std::vector<scene::Round> rounds;
  run.observer.on_round = [&](const scene::Round& round) { rounds.push_back(round); };
  const Packing packing = pack(marker, {}, run);
  ASSERT_FALSE(rounds.empty());
  for (std::size_t k = 0; k < rounds.size(); ++k) {
    EXPECT_LE(*rounds[k].bound, packing.length_after);
    EXPECT_LE(*rounds[k].bound, rounds[k].length);
    if (k == 0) continue;
    EXPECT_GE(*rounds[k].bound, *rounds[k - 1].bound);
    EXPECT_GE(*rounds[k].nodes, *rounds[k - 1].nodes);
  }
  EXPECT_LE(*rounds.back().bound, packing.bound);
  EXPECT_EQ(*rounds.back().nodes, packing.work.nodes);
}

TEST(Pack, CanBeCancelled) {
  const Marker marker = test::loose_marker(5, 3, 2);
  SumCache sums;
  std::stop_source source;
  scene::Run run{sums, source.get_token()};
  run.observer.on_round = [&](const scene::Round& round) {
    if (round.number == 5) source.request_stop();
  };
  const Packing packing = pack(marker, {}, run);
  EXPECT_EQ(packing.reason, scene::StopReason::kCancelled);
  EXPECT_EQ(packing.rounds, 5);
  EXPECT_TRUE(is_valid(packing.marker));
}

}  // namespace
}  // namespace selvage::packing
