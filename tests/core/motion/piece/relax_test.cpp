#include "core/motion/piece/relax.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stop_token>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::piece {
namespace {

using test::Layout;

Relaxation relaxed(const Marker& marker, std::uint32_t piece, int tilts = 0) {
  SumCache sums;
  const scene::Scene scene{marker, sums};
  return tilts == 0 ? relax(scene, PieceId{piece}) : relax_tilted(scene, PieceId{piece}, tilts);
}

// A square of 100 in a chamber of 300 x 200 whose walls are pieces; its lower left corner at (200, 100).
Marker chamber(Vec at) {
  Layout layout{400};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  const auto upright = layout.shape_of(test::rectangle(200, 400));
  const auto lying = layout.shape_of(test::rectangle(300, 100));
  layout.put(square, at).put(upright, {0, 0}).put(upright, {500, 0}).put(lying, {200, 0}).put(lying, {200, 300});
  return layout.marker();
}

TEST(Relax, PutsAPieceInTheMiddleOfItsRoom) {
  const Relaxation result = relaxed(chamber({200, 200}), 0);
  EXPECT_NEAR(static_cast<double>(result.piece.at.y), 150, 1);
  EXPECT_NEAR(result.freedom, 50, 1);
  EXPECT_GE(result.piece.at.x, 249);  // as free everywhere between
  EXPECT_LE(result.piece.at.x, 351);
}

TEST(Relax, SpacingDoesNotCountAsRoom) {
  Marker marker = chamber({250, 160});
  marker.spacing = 10;
  EXPECT_NEAR(relaxed(marker, 0).freedom, 40, 1);
}

TEST(Relax, TheEndOfTheMarkerLimitsTheRoom) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 300}).put(square, {200, 900});
  const Relaxation result = relaxed(layout.marker(), 0);
  EXPECT_NEAR(static_cast<double>(result.piece.at.x), 100, 1);
  EXPECT_NEAR(result.freedom, 100, 1);
}

TEST(Relax, ALockedPieceStays) {
  Marker marker = chamber({250, 160});
  marker.pieces[0].locked = true;
  const Relaxation result = relaxed(marker, 0, 9);
  EXPECT_EQ(result.piece, marker.pieces[0]);
  EXPECT_EQ(result.freedom, 0);
}

TEST(RelaxTilted, ATiltedPieceIsStraightened) {
  Layout layout{100'000};
  const auto bar = layout.shape_of(test::rectangle(900'000, 60'000));
  const auto wall = layout.shape_of(test::rectangle(50'000, 100'000));
  layout.put(bar, {90'000, 18'000}).put(wall, {0, 0}).put(wall, {1'050'000, 0});
  Marker marker = layout.marker();
  marker.shapes[0].tilt_limit = Angle::of_degrees(2);
  marker.pieces[0].orientation.tilt = Angle::of_degrees(1);
  ASSERT_TRUE(is_valid(marker));
  const Relaxation leaning = relaxed(marker, 0);
  const Relaxation straight = relaxed(marker, 0, 9);  // every half degree
  EXPECT_EQ(straight.piece.orientation.tilt, Angle{});
  EXPECT_NEAR(straight.freedom, 20'000, 2);
  EXPECT_LT(leaning.freedom, 15'000);
}

TEST(RelaxTilted, RespectsTheTiltLimit) {
  Marker marker = chamber({250, 160});
  marker.shapes[0].tilt_limit = Angle::of_degrees(0);
  EXPECT_EQ(relaxed(marker, 0, 9).piece.orientation, marker.pieces[0].orientation);
}

TEST(RelaxTilted, StaysWhenCancelled) {
  Marker marker = chamber({250, 160});
  marker.shapes[0].tilt_limit = Angle::of_degrees(10);
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  for (const int tilts : {0, 9}) {
    const auto stopped = repair_and_relax(marker, PieceId{0}, tilts, {sums, source.get_token()});
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->reason, scene::StopReason::kCancelled);
    EXPECT_EQ(stopped->marker, marker);
  }
}

RC_GTEST_PROP(RelaxLaws, TheWholeSquareIsFree, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  Marker marker = test::loose_marker(seed, 3, 2);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(*rc::gen::inRange(0, 4));
  if (*rc::gen::arbitrary<bool>()) marker.spacing = 500;
  RC_PRE(is_valid(marker));
  const auto piece = *rc::gen::inRange<std::uint32_t>(0, 6);
  const Coord length = length_of(marker);
  const Relaxation before = relaxed(marker, piece);
  const Relaxation result = relaxed(marker, piece, *rc::gen::inRange(1, 6));
  RC_ASSERT(result.freedom >= before.freedom);
  const auto half = static_cast<Coord>(std::max(0.0, result.freedom - 3));  // corners of sums are rounded
  for (const Coord x : {-half, Coord{0}, half}) {
    for (const Coord y : {-half, Coord{0}, half}) {
      marker.pieces[piece] = result.piece;
      marker.pieces[piece].at = result.piece.at + Vec{x, y};
      RC_ASSERT(is_valid(marker));
      RC_ASSERT(length_of(marker) <= length);
    }
  }
}

}  // namespace
}  // namespace selvage::motion::piece
