// Pairs of pieces that touch exactly, checked by Selvage's proof and by CGAL, on small lattices and on the largest.
#include <gtest/gtest.h>

#include <array>

#include "core/motion/piece/bump.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/nasty_pieces.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

using test::Random;
using test::reached;

constexpr std::array<Vec, 9> kUnitMoves{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// Tests the pair, and the pair with the second piece moved by one unit in every direction, with both predicates.
// Returns the number of moves that overlap.
int overlapping_moves(const Polygon& p, const Polygon& q) {
  int overlapping = 0;
  for (const Vec by : kUnitMoves) {
    const bool ours = overlap(test::placed(p), test::placed(q, by));
    EXPECT_EQ(ours, test::interiors_meet(p, geometry::moved(q, by))) << by.x << ' ' << by.y;
    overlapping += ours ? 1 : 0;
  }
  EXPECT_FALSE(overlap(test::placed(p), test::placed(q)));
  return overlapping;
}

TEST(ExtremeContacts, InAPointAlongAnEdgeAndInAHole) {
  for (const Coord size : {Coord{4}, Coord{1} << 20, Coord{1} << 38}) {
    SCOPED_TRACE(size);
    const Polygon square = test::rectangle(size, size);
    const Polygon diamond{{size, 0}, {2 * size, size}, {size, 2 * size}, {0, size}};
    const Polygon star = geometry::moved(test::pinwheel(size), {size, size});
    // Corner to corner, corner to edge, along a whole edge, and along part of an edge.
    EXPECT_EQ(overlapping_moves(square, geometry::moved(square, {size, size})), 1);
    EXPECT_EQ(overlapping_moves(diamond, geometry::moved(square, {2 * size, size / 2})), 3);
    EXPECT_EQ(overlapping_moves(square, geometry::moved(square, {size, 0})), 3);
    EXPECT_EQ(overlapping_moves(square, geometry::moved(square, {size, size / 2})), 3);
    EXPECT_EQ(overlapping_moves(star, geometry::moved(square, {2 * size, size / 2})),
              3);  // the tip of an arm at an edge
    EXPECT_EQ(overlapping_moves(star, geometry::moved(star, {2 * size, -2})),
              0);  // two tips, which are thinner than a unit there
    // In a hole that the piece fills exactly: every move overlaps.
    const Polygon ring = test::broken_ring(3 * size, size, 1);
    EXPECT_EQ(overlapping_moves(ring, geometry::moved(square, {size, size})), 8);
  }
  reached("largest size, lattice units", static_cast<double>(Coord{3} << 38));
}

// A bump always brings two pieces together to the lattice unit.
TEST(ExtremeContacts, WhereBumpsBringRandomPiecesTogether) {
  Random random{23};
  int touching = 0;
  int pairs = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Coord extent = random.between(8, 100) << random.between(0, 28);
    const Polygon p = trial % 2 == 0 ? test::random_star(random, 12, extent) : test::random_convex(random, 8, extent);
    const Polygon q = test::random_polygon(random, extent);
    test::Layout layout{4 * extent};
    layout.put(layout.shape_of(p), -box_of(p).low, 0, true);
    layout.put(layout.shape_of(q), Vec{2 * extent, 0} - box_of(q).low);
    SumCache sums;
    const auto result = motion::piece::repair_and_bump(layout.marker(), PieceId{1}, -1, -1e-3, {sums});
    ASSERT_TRUE(result);
    const Polygon obstacle = placed_outline(result->marker, PieceId{0});
    const Polygon bumped = placed_outline(result->marker, PieceId{1});
    ++pairs;
    // Where the piece was guided past the other, they no longer touch.
    touching += overlapping_moves(obstacle, bumped) > 0 ? 1 : 0;
  }
  reached("pairs", pairs);
  reached("of them a unit from overlapping", touching);
  EXPECT_GE(touching, 280);
}

// A bar in a slot that is `play` units wider than the bar, compacted towards the slot's floor.
motion::compaction::Compaction drawn_into_slot(Coord size, Coord play) {
  test::Layout layout{3 * size + play};
  layout.put(layout.shape_of({{0, 0},
                              {4 * size, 0},
                              {4 * size, size},
                              {size, size},
                              {size, 2 * size + play},
                              {4 * size, 2 * size + play},
                              {4 * size, 3 * size + play},
                              {0, 3 * size + play}}),
             {0, 0});
  layout.put(layout.shape_of(test::rectangle(3 * size, size)), {3 * size, size + play / 2});
  return test::soundly_compacted(layout.marker());
}

TEST(ExtremeContacts, ABarSlidesToTheFloorOfASlotFourUnitsWider) {
  for (const Coord size : {Coord{100}, Coord{1} << 36}) {
    for (const Coord play : {4, 5, 50}) EXPECT_EQ(drawn_into_slot(size, play).length_after, 4 * size) << play;
  }
}

// With less play, the floor, an edge as long as the play, is taken for rounding (core/model/free_region.cpp).  The
// program then lets the bar pass through it to the strip's edge, a move of 3 units.  Half of that is proved, 1.5 of the
// 2 units available, and half of the next move is too far again.  With a play of one unit the bar does not move at all.
TEST(ExtremeContacts, ABarInATighterSlotStopsShortButSound) {
  constexpr Coord kSize = Coord{1} << 36;
  constexpr std::array<double, 4> kLeft{0.5, 2, 0.5, 0.5};
  for (const Coord play : {0, 1, 2, 3}) {
    const motion::compaction::Compaction result = drawn_into_slot(kSize, play);
    const double left = static_cast<double>(result.length_after - 4 * kSize) / static_cast<double>(kSize);
    reached("play of " + std::to_string(play) + " units: left of a way of 2", left);
    EXPECT_LE(left, kLeft[static_cast<std::size_t>(play)] + 1e-6);
  }
}

}  // namespace
}  // namespace selvage::test
