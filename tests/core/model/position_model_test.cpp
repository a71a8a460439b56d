#include "core/model/position_model.h"

#include <gtest/gtest.h>

#include "tests/core/motion/markers.h"

namespace selvage::model {
namespace {

using test::Layout;

TEST(PositionModel, BuildsOnlyWhatTheSceneNeeds) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {200, 0}).put(square, {400, 0}, 0, true);
  const marker::PlacedPieces pieces{layout.marker()};
  const Ties ties{{0, 0, Ties::kFixed}, {0, 0, Ties::kFixed}};
  PositionModel model{pieces, layout.marker().strip, ties};
  EXPECT_EQ(model.program().columns(), 2);  // two pieces of one group, one fixed
  EXPECT_EQ(model.x_column(0), model.x_column(1));
  EXPECT_EQ(model.y_column(0), model.y_column(1));
  EXPECT_FALSE(model.x_column(2) || model.y_column(2));
  EXPECT_EQ(model.program().lower[0], 0);    // the group's first piece is at the left edge
  EXPECT_EQ(model.program().upper[1], 900);  // units are thousandths of the width
  model.add({{0, 1}, 1, 0, -50});
  EXPECT_EQ(model.program().rows(), 0);  // within a group nothing can change
  model.add({{1, 2}, 1, 0, -50});
  EXPECT_EQ(model.program().rows(), 1);
  model.add_length(1, 500, 0);
  model.add_right_wall(0);
  model.add_right_wall(2);
  EXPECT_EQ(model.program().rows(), 2);        // a fixed piece bounds the length itself
  EXPECT_EQ(model.program().lower.back(), 0);  // the fixed piece is the last
}

TEST(PositionModel, OfAPieceLockedOnAnAxisHasOnlyTheOtherColumn) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 0}).put(square, {200, 0});
  Marker marker = layout.marker();
  marker.pieces[0].locked = {true, false, false};
  const marker::PlacedPieces pieces{marker};
  PositionModel model{pieces, marker.strip, ties_of(marker)};
  EXPECT_EQ(model.program().columns(), 3);
  EXPECT_FALSE(model.x_column(0));
  model.add({{0, 1}, 0.6, 0.8, -50});
  EXPECT_EQ(model.program().row(0).size(), 3U);
  const std::vector<double> x{1, 2, 3};
  const auto moves = model.displacements(x);
  EXPECT_EQ(moves[0].x, 0);
  EXPECT_EQ(moves[0].y, 1);  // units are thousandths of the width
  EXPECT_EQ(moves[1].x, 2);
}

TEST(PositionModel, KeepsTheMargins) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {50, 60});
  Marker marker = layout.marker();
  marker.strip.margin = 20;
  marker.strip.longest = 400;
  const marker::PlacedPieces pieces{marker};
  PositionModel model{pieces, marker.strip, ties_of(marker)};
  EXPECT_EQ(model.program().lower, (std::vector<double>{-30, -40}));
  EXPECT_EQ(model.program().upper, (std::vector<double>{230, 820}));
}

TEST(PositionModel, HasTheRoomsOfPiecesAsBounds) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {50, 60}).put(square, {300, 0});
  Marker marker = layout.marker();
  marker.strip.below = 10;
  marker.pieces[0].rules = {.above = 20, .from = 40, .to = 500};
  marker.pieces[1].rules.on_fold = true;
  const marker::PlacedPieces pieces{marker};
  PositionModel model{pieces, marker.strip, ties_of(marker)};
  EXPECT_EQ(model.program().lower, (std::vector<double>{-10, -50, -300, 0}));
  EXPECT_EQ(model.program().upper, (std::vector<double>{350, 820, lp::kInfinity, 0}));
  EXPECT_EQ(model.program().rows(), 0);
}

TEST(PositionModel, HasAColumnForAShadeAndTwoRowsForEachOfItsPieces) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {50, 0}).put(square, {300, 0}).put(square, {600, 0}, 0, true);
  Marker marker = layout.marker();
  marker.shade = 700;
  for (Piece& piece : marker.pieces) piece.rules.shade = "A";
  const marker::PlacedPieces pieces{marker};
  PositionModel model{pieces, marker.strip, ties_of(marker)};
  ASSERT_EQ(model.program().columns(), 5);  // the last: the motion of the shade's cloth, which begins at 50
  EXPECT_EQ(model.program().bound, (std::vector<double>{0, -600, -250, -350, -550, -50}));
  ASSERT_EQ(model.shade_rows().size(), 6U);
  EXPECT_EQ(model.program().row(model.shade_rows()[5].in_program).size(), 1U);  // the locked piece has no column
}

}  // namespace
}  // namespace selvage::model
