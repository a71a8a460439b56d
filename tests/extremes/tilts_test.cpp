// Tilts by tiny angles, and tilts exactly at the limit.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/marker/validity.h"
#include "core/motion/dragging/drag.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/piece/bump.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "tests/core/motion/markers.h"
#include "tests/extremes/reached.h"
#include "tests/extremes/soundness.h"
#include "tests/support/garment.h"

namespace selvage::test {
namespace {

using test::reached;

// Every vertex of a piece turned by 1e-9 degrees is rounded to the nearest lattice point, on any lattice.
TEST(ExtremeTilts, ABillionthOfADegree) {
  const long double radians = 1e-9L * std::numbers::pi_v<long double> / 180;
  for (const Coord size : {Coord{1} << 20, Coord{1} << 28, Coord{1} << 38}) {
    const Polygon shape{{0, 0}, {2 * size, size / 7}, {size, size}, {-size / 3, size - 1}};
    const Polygon image = turned(shape, Angle::of_degrees(1e-9));
    ASSERT_EQ(image.size(), shape.size());
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const auto x = static_cast<long double>(shape[k].x);
      const auto y = static_cast<long double>(shape[k].y);
      EXPECT_EQ(image[k].x, std::llround(x * std::cos(radians) - y * std::sin(radians)));
      EXPECT_EQ(image[k].y, std::llround(x * std::sin(radians) + y * std::cos(radians)));
    }
    EXPECT_EQ(image == shape, size < Coord{1} << 30);  // then the motion is less than half a unit
    reached("a corner moved, on a piece of " + std::to_string(2 * size), static_cast<double>(image[1].y - shape[1].y));
  }
}

Marker tilting_marker(double limit) {
  Marker marker = test::loose_marker(3, 3, 2);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
  return marker;
}

TEST(ExtremeTilts, LimitsHoldToTheLastBit) {
  for (const double limit : {std::numeric_limits<double>::denorm_min(), 1e-9, 0.1, 3.0, 45.0}) {
    SCOPED_TRACE(limit);
    const Marker marker = tilting_marker(limit);
    for (const motion::tilting::TiltMethod method :
         {motion::tilting::TiltMethod::kLinearisation, motion::tilting::TiltMethod::kRelaxation}) {
      SumCache sums;
      const auto result = tilt(marker, tilt_settings(method, motion::compaction::Accuracy::kStandard), {sums});
      ASSERT_TRUE(result) << result.error().message;
      test::expect_valid_twice(result->marker);
      EXPECT_LE(result->length_after, result->length_compacted);
      EXPECT_LE(result->farthest_tilt.degrees, limit);
      for (const Piece& piece : result->marker.pieces) EXPECT_LE(std::abs(piece.orientation.tilt.degrees), limit);
      EXPECT_TRUE(make_marker(result->marker));
      if (method == motion::tilting::TiltMethod::kLinearisation) {
        char name[64];
        std::snprintf(name, sizeof name, "limit %g: farthest tilt", limit);
        reached(name, result->farthest_tilt.degrees);
      }
    }
  }
}

TEST(ExtremeTilts, AtTheLimitIsAllowedAndABitBeyondIsNot) {
  for (const double limit : {1e-9, 0.1, 3.0, 45.0}) {
    Marker marker = tilting_marker(limit);
    for (const double sign : {1.0, -1.0}) {
      marker.pieces[0].orientation.tilt = Angle::of_degrees(sign * limit);
      EXPECT_TRUE(make_marker(marker)) << limit;
      marker.pieces[0].orientation.tilt = Angle::of_degrees(sign * std::nextafter(limit, 90));
      const auto refused = make_marker(marker);
      ASSERT_FALSE(refused) << limit;
      EXPECT_EQ(refused.error().code, ErrorCode::kOrientationNotAllowed);
      EXPECT_EQ(refused.error().field, "/pieces/0/rotation");
    }
  }
  reached("beyond the limit by, degrees", std::nextafter(1e-9, 90) - 1e-9);
}

// A piece that starts at its limit, or one rounding step beyond it, turns back or keeps its tilt.
TEST(ExtremeTilts, PiecesThatComeAtTheLimitTiltNoFarther) {
  for (const double came : {3.0, std::nextafter(3.0, 90), 2.9999999999}) {
    Marker marker = tilting_marker(3);
    for (Piece& piece : marker.pieces) piece.orientation.tilt = Angle::of_degrees(came);
    SumCache sums;
    const auto result = tilt(
        marker, tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard),
        {sums});
    ASSERT_TRUE(result) << result.error().message;
    test::expect_valid_twice(result->marker);
    for (const Piece& piece : result->marker.pieces) {
      EXPECT_LE(std::abs(piece.orientation.tilt.degrees), std::max(came, 3.0));
    }
  }
}

// Pieces on a lattice so fine that a billionth of a degree moves their corners; every second piece is tilted in the
// other direction.
Marker tilted_marker(double limit, double tilt) {
  Marker marker = test::loose_marker(3, 3, 2, Coord{1} << 36);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    marker.pieces[k].orientation.tilt = Angle::of_degrees(k % 2 == 0 ? tilt : -tilt);
  }
  return marker;
}

void expect_motions_from(const Marker& marker) {
  const motion::compaction::Compaction compaction =
      test::soundly_compacted(marker);  // orientations must be exactly equal
  EXPECT_LT(compaction.length_after, compaction.length_before);
  SumCache sums;
  const auto floated = float_apart(
      compaction.marker, float_settings(motion::floating::FloatMode::kLargestMinimum, Coord{1} << 30), {sums});
  ASSERT_TRUE(floated) << floated.error().message;
  test::expect_sound(compaction.marker, floated->marker);
  const auto bumped = motion::piece::repair_and_bump(marker, PieceId{5}, -1, 0.1, {sums});
  ASSERT_TRUE(bumped) << bumped.error().message;
  test::expect_sound(marker, bumped->marker);
  test::expect_sound(marker, drag(marker, PieceId{5}, {0, 0}, motion::dragging::DragMode::kPush, {sums}).marker);
  Marker overlapping = marker;
  overlapping.pieces[2].at.x -= Coord{1} << 34;
  const auto separated = motion::separation::separate(overlapping, {}, {sums});
  ASSERT_TRUE(separated) << separated.error().message;
  ASSERT_TRUE(separated->apart);
  test::expect_sound(overlapping, separated->marker);
}

TEST(ExtremeTilts, MotionsFromPiecesThatLieTilted) {
  struct Start {
    double limit, tilt;
  };
  for (const auto& [limit, tilt_by] : {Start{3, 1e-9}, Start{1e-9, 1e-9}, Start{1e-9, std::nextafter(1e-9, 0)},
                                       Start{3, 3}, Start{3, std::nextafter(3.0, 0)}, Start{45, 45}}) {
    SCOPED_TRACE(testing::Message() << limit << ' ' << tilt_by);
    const Marker marker = tilted_marker(limit, tilt_by);
    ASSERT_TRUE(make_marker(marker));
    EXPECT_NE(placed_outline(marker, PieceId{0}), placed_outline(tilted_marker(limit, 0), PieceId{0}));
    expect_motions_from(marker);
    for (const motion::tilting::TiltMethod method :
         {motion::tilting::TiltMethod::kLinearisation, motion::tilting::TiltMethod::kRelaxation}) {
      SumCache sums;
      const auto result = tilt(marker, tilt_settings(method, motion::compaction::Accuracy::kDraft), {sums});
      ASSERT_TRUE(result) << result.error().message;
      test::expect_valid_twice(result->marker);
      EXPECT_LE(result->length_after, result->length_compacted);
      EXPECT_LE(result->farthest_tilt.degrees, limit);
      EXPECT_TRUE(make_marker(result->marker));
    }
  }
  reached("starts", 6);
}

TEST(ExtremeTilts, LimitsOutsideTheRangeAreRefused) {
  const Marker marker = tilting_marker(3);
  SumCache sums;
  for (const double limit : {-std::numeric_limits<double>::denorm_min(), std::nextafter(45.0, 90.0), std::nan(""),
                             std::numeric_limits<double>::infinity()}) {
    motion::tilting::TiltSettings settings =
        tilt_settings(motion::tilting::TiltMethod::kLinearisation, motion::compaction::Accuracy::kStandard);
    settings.limit = Angle::of_degrees(limit);
    const auto refused = tilt(marker, settings, {sums});
    ASSERT_FALSE(refused) << limit;
    EXPECT_EQ(refused.error().code, ErrorCode::kOutOfRange);
    EXPECT_NE(refused.error().message.find("45"), std::string::npos) << refused.error().message;
  }
}

}  // namespace
}  // namespace selvage::test
