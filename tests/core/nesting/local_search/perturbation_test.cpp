// Tests of core/nesting/local_search/perturbation.h: what a perturbation leaves as it is.
#include "core/nesting/local_search/perturbation.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/nesting/unplaced_pieces.h"

namespace selvage::nesting::local_search {
namespace {

using test::kSide;
using test::rectangle;

// Twelve pieces in a row, the first of them locked.
Marker row_of_pieces(const std::vector<Polygon>& outlines) {
  Marker marker = test::unplaced_pieces(outlines, 12, 7 * kSide);
  for (Piece& piece : marker.unplaced) {
    piece.at = {static_cast<Coord>(marker.pieces.size()) * 4 * kSide, 0};
    piece.locked.x = piece.locked.y = marker.pieces.empty();
    marker.pieces.push_back(piece);
  }
  marker.unplaced.clear();
  return marker;
}

bool same(const layout::Place& a, const layout::Place& b) {
  return a.x == b.x && a.y == b.y && a.turn == b.turn;
}

// What a hundred perturbations, one after another, do to the row.
void expect_of_all(const std::vector<Polygon>& outlines) {
  const Marker marker = row_of_pieces(outlines);
  SumCache sums;
  const auto set = layout::piece_set_of(marker, layout::PlacedPiecesMay::kMove, sums);
  ASSERT_TRUE(set);
  depth::DepthMaps maps{*set, {10, 1}, std::size_t{1} << 22};
  layout::Dice dice{7};
  layout::Layout layout = to_layout(*set, marker);
  const layout::Layout before = layout;
  for (int k = 0; k < 100; ++k) {
    const layout::Layout last = layout;
    perturb(*set, maps, dice, layout);
    const auto stays = [&](std::size_t i) { return same(layout.places[i], last.places[i]); };
    std::size_t moved = 0;
    for (std::size_t i = 0; i < set->size(); ++i) moved += stays(i) ? 0 : 1;
    EXPECT_GE(moved, 1U) << "perturbation " << k;
    EXPECT_TRUE(same(layout.places[0], before.places[0])) << "perturbation " << k << ": a locked piece moved";
    for (std::size_t i = 1; i < set->size(); ++i) {
      const RealBox fit = inner_fit(*set, layout, i, layout.places[i].turn);
      EXPECT_GE(layout.places[i].x, fit.low_x);
      EXPECT_LE(layout.places[i].x, fit.high_x);
      EXPECT_GE(layout.places[i].y, fit.low_y);
      EXPECT_LE(layout.places[i].y, fit.high_y);
    }
  }
}

TEST(Perturbation, MovesPiecesWithinTheStrip) {
  expect_of_all({rectangle(2 * kSide, kSide), rectangle(kSide, 3 * kSide), rectangle(kSide, kSide)});
}

TEST(Perturbation, MovesEqualPieces) {
  expect_of_all({rectangle(2 * kSide, kSide)});
}

}  // namespace
}  // namespace selvage::nesting::local_search
