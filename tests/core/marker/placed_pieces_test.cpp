// Tests of core/marker/placed_pieces.h: layouts, close pairs and conflicts, against brute force.
#include "core/marker/placed_pieces.h"

#include <gtest/gtest.h>

#include "tests/core/marker/random_layout.h"
#include "tests/core/marker/squares.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

TEST(PlacedPieces, AreTheMarkersOutlines) {
  Random random{201};
  const Marker marker = random_layout(random, 50, 1000);
  const marker::PlacedPieces pieces{marker};
  ASSERT_EQ(pieces.size(), 50U);
  EXPECT_EQ(pieces.length(), length_of(marker));
  for (std::uint32_t i = 0; i < 50; ++i) {
    const Polygon outline = placed_outline(marker, {i});
    const geometry::PlacedPolygon piece = pieces[i];
    ASSERT_EQ(moved({piece.vertices.begin(), piece.vertices.end()}, piece.at), outline);
    ASSERT_EQ(pieces.box(i), box_of(outline));
    ASSERT_EQ(piece.placed_box(), box_of(outline));
  }
}

TEST(PlacedPieces, CanBeMoved) {
  marker::PlacedPieces pieces{squares({{0, 0}, {20, 0}})};
  pieces.place({{5, 5}, {1, 80}});
  EXPECT_EQ(pieces.at(1), (Vec{1, 80}));
  EXPECT_EQ(pieces.length(), 15);
}

TEST(PairsWithin, EqualBruteForce) {
  Random random{202};
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    const Marker marker = random_layout(random, 40, random.between(10, 800));
    const marker::PlacedPieces pieces{marker};
    const Coord distance = random.chance(30) ? 0 : random.between(1, 100);
    std::vector<marker::PiecePair> expected;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      for (std::uint32_t j = i + 1; j < pieces.size(); ++j) {
        if (pieces.box(i).grown(distance).overlaps(pieces.box(j))) expected.emplace_back(i, j);
      }
    }
    ASSERT_EQ(pairs_within(pieces, distance), expected);
  }
}

TEST(PairsWithin, ExcludePairsAtExactlyTheDistance) {
  const marker::PlacedPieces pieces{squares({{0, 0}, {15, 0}, {10, 10}})};
  EXPECT_EQ(pairs_within(pieces, 0), (std::vector<marker::PiecePair>{}));
  EXPECT_EQ(pairs_within(pieces, 5), (std::vector<marker::PiecePair>{{0, 2}, {1, 2}}));
  EXPECT_EQ(pairs_within(pieces, 6), (std::vector<marker::PiecePair>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(PlacedPieces, CanReplaceTheOutlineOfOnePiece) {
  Random random{204};
  Marker marker = random_layout(random, 6, 1000);
  marker::PlacedPieces pieces{marker};
  const Vec far{5000, 7};
  const Polygon square{{0, 0}, {30, 0}, {30, 30}, {0, 30}};
  pieces.replace(2, square, far, {});
  EXPECT_EQ(pieces.box(2), (Box{{5000, 7}, {5030, 37}}));
  EXPECT_EQ(pieces.at(2), far);
  EXPECT_EQ(pieces.length(), 5030);
  for (const std::uint32_t other :
       {0U, 1U, 3U, 4U, 5U}) {  // pieces of the same shape share its polygon; a replacement affects only one piece
    EXPECT_EQ(pieces.box(other), box_of(placed_outline(marker, {other})));
  }
}

}  // namespace
}  // namespace selvage::test
