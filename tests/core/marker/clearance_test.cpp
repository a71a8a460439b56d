#include "core/marker/clearance.h"

#include <gtest/gtest.h>

#include "tests/core/marker/random_layout.h"
#include "tests/core/marker/squares.h"

namespace selvage::test {
namespace {

Marker random_spaced_layout(Random& random) {
  Marker marker = random_layout(random, 20, random.between(50, 500));
  if (random.chance(50)) marker.spacing = random.between(1, 40);
  if (random.chance(50)) {
    for (Piece& piece : marker.pieces) piece.buffer = random.between(0, 30);
  }
  return marker;
}

TEST(Conflicts, EqualBruteForce) {
  Random random{203};
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    const Marker marker = random_spaced_layout(random);
    const marker::PlacedPieces pieces{marker};
    std::vector<marker::PiecePair> expected;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      for (std::uint32_t j = i + 1; j < pieces.size(); ++j) {
        const Coord spacing = std::max(marker.spacing, marker.pieces[i].buffer + marker.pieces[j].buffer);
        const bool conflict = spacing == 0 ? overlap(pieces[i], pieces[j]) : closer_than(pieces[i], pieces[j], spacing);
        if (conflict) expected.emplace_back(i, j);
      }
    }
    ASSERT_EQ(conflicts(pieces), expected);
    ASSERT_EQ(any_conflict(pieces), !expected.empty());
  }
}

TEST(Conflicts, AreOverlapsBeyondTheSmallerAllowance) {
  Marker marker = squares({{0, 0}, {8, 3}, {15, 3}});
  const auto found = [&] { return conflicts(marker::PlacedPieces{marker}); };
  const std::vector<marker::PiecePair> both{{0, 1}, {1, 2}};
  EXPECT_EQ(found(), both);
  marker.overlap = 2;
  EXPECT_EQ(found(), (std::vector<marker::PiecePair>{{1, 2}}));
  marker.overlap = 3;
  EXPECT_TRUE(found().empty());
  marker.pieces[1].overlap = 2;
  EXPECT_EQ(found(), (std::vector<marker::PiecePair>{{1, 2}}));
  marker.pieces[1].overlap = 0;
  EXPECT_EQ(found(), both);
  marker.pieces[1].overlap = {};
  marker.pieces[2].overlap = 50;  // the smaller of the two counts
  EXPECT_TRUE(found().empty());
  marker.pieces[0].buffer = 1;  // a buffer overrides the allowance of its pairs
  EXPECT_EQ(found(), (std::vector<marker::PiecePair>{{0, 1}}));
  marker.pieces[0].buffer = 0;
  marker.spacing = 1;
  EXPECT_EQ(found(), both);
}

TEST(Conflicts, WithTheStripAreNeverAllowed) {
  Marker marker = squares({{-1, 0}});
  marker.overlap = 5;
  EXPECT_FALSE(all_clear(marker::PlacedPieces{marker}, marker.strip));
}

// Whether exactly one of these pieces or, with `both`, at least one of them has the conflict.
bool conflict_of(const marker::PlacedPieces& pieces, const std::vector<bool>& of, bool both) {
  const auto found = conflicts(pieces);
  return std::any_of(found.begin(), found.end(), [&](const marker::PiecePair& pair) {
    return of[pair.first] != of[pair.second] || (both && of[pair.first]);
  });
}

TEST(Clearance, OfPiecesThatMoveIsThatOfTheLayoutAfterwards) {
  Random random{205};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Marker marker = random_spaced_layout(random);
    const marker::PlacedPieces pieces{marker};
    const Vec by = random.point(-300, 300);
    std::vector<bool> moving(pieces.size());
    std::vector<Vec> moves(pieces.size());
    for (std::size_t k = random.below(4) + 1; k > 0; --k) moving[random.below(pieces.size())] = true;
    for (std::size_t i = 0; i < pieces.size(); ++i) moves[i] = moving[i] ? by : Vec{};
    marker::PlacedPieces moved = pieces;
    moved.move_by(moves);
    ASSERT_EQ(are_clear(pieces, moving, by), !conflict_of(moved, moving, false)) << trial;

    const auto piece = static_cast<std::uint32_t>(random.below(pieces.size()));
    std::vector<bool> alone(pieces.size());
    alone[piece] = true;
    geometry::PlacedPolygon elsewhere = pieces[piece];
    elsewhere.at = elsewhere.at + by;
    ASSERT_EQ(is_clear(pieces, piece, elsewhere), are_clear(pieces, alone, by)) << trial;
  }
}

TEST(Clearance, OfChangedPiecesIsThatOfTheirPairs) {
  Random random{206};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const marker::PlacedPieces pieces{random_spaced_layout(random)};
    std::vector<bool> is_changed(pieces.size());
    std::vector<std::uint32_t> changed;  // few of them are searched one by one, many by a sweep
    const std::size_t percent = random.chance(50) ? 10 : 95;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (!random.chance(static_cast<int>(percent))) continue;
      is_changed[i] = true;
      changed.push_back(i);
    }
    ASSERT_EQ(are_clear(pieces, changed), !conflict_of(pieces, is_changed, true)) << trial;
  }
}

TEST(Clearance, InsideMeansWithinTheStripAndItsMargins) {
  Marker marker = squares({{0, 0}, {50, 90}});
  const auto is_inside = [&] { return are_inside(marker::PlacedPieces{marker}, marker.strip); };
  EXPECT_TRUE(is_inside());
  EXPECT_TRUE(all_clear(marker::PlacedPieces{marker}, marker.strip));
  marker.pieces[1].at.y = 91;
  EXPECT_FALSE(is_inside());
  EXPECT_FALSE(all_clear(marker::PlacedPieces{marker}, marker.strip));
  EXPECT_EQ(marker::protrusion_of(marker::PlacedPieces{marker}, 1, marker.strip), 1);
}

}  // namespace
}  // namespace selvage::test
