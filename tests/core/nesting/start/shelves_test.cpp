// Tests of core/nesting/start/shelves.h: the layout that needs no search is valid and complete.
#include "core/nesting/start/shelves.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/marker/validity.h"
#include "tests/core/nesting/unplaced_pieces.h"
#include "tests/laws/random_marker.h"

namespace selvage::nesting::start {
namespace {

TEST(Shelves, AreValidAndHoldEveryPiece) {
  test::Random random{1};
  int held = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Marker marker = test::taken_off(test::random_marker(random));
    marker.strip.longest.reset();
    for (Piece& piece : marker.unplaced) piece.buffer = random.between(0, marker.strip.width / 1000);
    SumCache sums;
    const auto set = piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums);
    ASSERT_TRUE(set) << set.error().message;
    const auto shelves = on_shelves(marker, *set, std::vector<bool>(marker.pieces.size(), true));
    ASSERT_TRUE(shelves) << shelves.error().message;
    EXPECT_TRUE(is_valid(*shelves)) << "trial " << trial;
    EXPECT_TRUE(shelves->unplaced.empty());
    ASSERT_EQ(shelves->pieces.size(), marker.pieces.size() + marker.unplaced.size());
    EXPECT_TRUE(std::equal(marker.pieces.begin(), marker.pieces.end(), shelves->pieces.begin()));
    held += static_cast<int>(marker.pieces.size());
  }
  EXPECT_GT(held, 0);
}

TEST(Shelves, RefuseToReachBeyondTheLattice) {
  const Coord width = kLatticeLimit / 4;
  const Marker marker = test::unplaced_pieces({test::rectangle(width, width)}, 5, width);
  SumCache sums;
  const auto set = piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  const auto shelves = on_shelves(marker, *set, {});
  ASSERT_FALSE(shelves);
  EXPECT_EQ(shelves.error().code, ErrorCode::kBeyondLattice);
}

}  // namespace
}  // namespace selvage::nesting::start
