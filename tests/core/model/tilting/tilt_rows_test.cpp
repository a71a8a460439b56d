#include "core/model/tilting/tilt_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/marker/validity.h"
#include "core/model/tilting/tilt_model.h"
#include "tests/core/motion/markers.h"

namespace selvage::model::tilting {
namespace {

using test::Layout;

constexpr double kTurn = 1e-4;  // radians

// For each row of the first pair: the room that a rotation of either piece leaves in the contact, and the room
// according to the row.
std::vector<TiltRow> rows_of(const Marker& marker, double turn = 0.01) {
  SumCache sums;
  const marker::PlacedPieces pieces{marker};
  const minkowski::Obstacle obstacle =
      sums.obstacle(oriented_outline(marker, PieceId{0}, sums), oriented_outline(marker, PieceId{1}, sums));
  const RegionSettings region{RegionRule::kGreedy, 1e6, marker.spacing};
  const auto sides = free_region(obstacle, pieces.at(1) - pieces.at(0), region);
  return tilt_rows({0, 1}, pieces[0], pieces[1], sides, {turn, 1e6, 0, marker.spacing, ModelUnit::of(1000)});
}

// A vertex rotated about a pivot.
RealVec turned_about(RealVec v, RealVec pivot, double turn) {
  const double x = v.x - pivot.x;
  const double y = v.y - pivot.y;
  return {pivot.x + std::cos(turn) * x - std::sin(turn) * y, pivot.y + std::sin(turn) * x + std::cos(turn) * y};
}

// A plate below a triangle that points down at it from 10 mm above.
Marker tip_above_plate() {
  Layout layout{1'000'000};
  const auto plate = layout.shape_of(test::rectangle(400'000, 100'000));
  const auto tip = layout.shape_of({{0, 0}, {150'000, 200'000}, {-50'000, 200'000}});
  layout.put(plate, {0, 0}).put(tip, {300'000, 110'000});
  return layout.marker();
}

TEST(TiltRows, AVertexOfTheSecondOnAnEdgeOfTheFirst) {  // equation (6.3)
  const Marker marker = tip_above_plate();
  const marker::PlacedPieces pieces{marker};
  const auto rows = rows_of(marker);
  ASSERT_EQ(rows.size(), 1U);
  const TiltRow& row = rows[0];
  EXPECT_NEAR(row.row.ny, 1, 1e-12);
  EXPECT_NEAR(row.row.bound, -10'000, 1e-6);
  const RealVec tip{300'000, 110'000};
  const RealVec by_q = turned_about(tip, pivot_of(pieces[1]), kTurn);
  EXPECT_NEAR(row.second_turn * kTurn, by_q.y - tip.y, 1e-3 * std::abs(by_q.y - tip.y));
  // The plate's upper edge rotates about the plate's middle (200, 50) and rises below the tip.
  const double rise = 50'000 / std::cos(kTurn) - 50'000 + std::tan(kTurn) * 100'000;
  EXPECT_NEAR(row.first_turn * kTurn, -rise, 1e-3 * rise);
}

TEST(TiltRows, AVertexOfTheFirstOnAnEdgeOfTheSecond) {  // equation (6.2): the same contact, the pieces exchanged
  const auto rows = rows_of(tip_above_plate());
  Marker exchanged = tip_above_plate();
  std::swap(exchanged.pieces[0], exchanged.pieces[1]);
  const auto mirrored = rows_of(exchanged);
  ASSERT_EQ(mirrored.size(), 1U);
  EXPECT_NEAR(mirrored[0].row.ny, -1, 1e-12);
  EXPECT_EQ(mirrored[0].row.bound, rows[0].row.bound);
  EXPECT_EQ(mirrored[0].first_turn, rows[0].second_turn);
  EXPECT_EQ(mirrored[0].second_turn, rows[0].first_turn);
}

TEST(TiltRows, EdgesAlongEachOtherAreHeldAtBothEnds) {
  Layout layout{1'000'000};
  const auto plate = layout.shape_of(test::rectangle(400'000, 100'000));
  const auto block = layout.shape_of(test::rectangle(200'000, 300'000));
  layout.put(plate, {0, 0}).put(block, {100'000, 100'000});
  const auto rows = rows_of(layout.marker());
  // Some row forbids a rotation of either piece in either direction.
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(
        std::any_of(rows.begin(), rows.end(), [&](const TiltRow& r) { return sign * r.second_turn < -90'000; }));
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const TiltRow& r) { return sign * r.first_turn < -90'000; }));
  }
  for (const TiltRow& row : rows) EXPECT_GE(row.row.bound, -1e-9);
}

TEST(TiltRows, WallsAreTouchedByTheVertexThatReachesThemFirst) {
  Layout layout{1'000'000};
  const auto bar = layout.shape_of(test::rectangle(400'000, 100'000));
  layout.put(bar, {50'000, 0});
  const marker::PlacedPieces pieces{layout.marker()};
  const auto low = wall_rows(pieces[0], 0, 1, 0, 0.01);
  ASSERT_EQ(low.size(), 2U);
  EXPECT_EQ(low[0].turn, -low[1].turn);
  EXPECT_EQ(std::abs(low[0].turn), 200'000);
  EXPECT_EQ(low[0].bound, 0);
  const auto left = wall_rows(pieces[0], 1, 0, 0, 0.01);
  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].bound, -50'000);
  EXPECT_EQ(std::abs(left[0].turn), 50'000);
}

TEST(TiltModel, OnlyPiecesThatMayTiltHaveATiltColumn) {
  Layout layout{1'000'000};
  const auto bar = layout.shape_of(test::rectangle(400'000, 100'000));
  layout.put(bar, {0, 200'000}).put(bar, {400'000, 200'000}).put(bar, {800'000, 200'000}, 0, true);
  const marker::PlacedPieces pieces{layout.marker()};
  const std::vector<TurnRange> turns{{-0.01, 0}, {}, {}};
  TiltModel model{pieces, layout.marker().strip, ties_of(layout.marker()), turns, 50'000};
  EXPECT_EQ(model.program().columns(), 5);
  EXPECT_FALSE(model.turn_column(1));
  EXPECT_FALSE(model.turn_column(2));  // fixed
  const auto turn = static_cast<std::size_t>(model.turn_column(0).value());
  EXPECT_EQ(model.program().upper[turn], 0);
  EXPECT_NEAR(model.program().lower[turn], -0.01 * radius_of(pieces[0]) / 1000, 1e-9);
  std::vector<double> x(5, 0);
  x[turn] = model.program().lower[turn];
  EXPECT_NEAR(model.turns(x)[0], -0.01, 1e-15);
  EXPECT_GE(model.turns(x)[0], -0.01);
}

}  // namespace
}  // namespace selvage::model::tilting
