#include "core/motion/tilting/tilt.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/marker/validity.h"
#include "core/model/tilting/tilt_rows.h"
#include "core/motion/piece/tilted_piece.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::tilting {
namespace {

using test::Layout;

TiltSettings settings_of(TiltMethod method) {
  return tilt_settings(method, compaction::Accuracy::kStandard);
}
TiltSettings limited(double degrees, TiltMethod method = TiltMethod::kLinearisation) {
  TiltSettings settings = settings_of(method);
  settings.limit = Angle::of_degrees(degrees);
  return settings;
}

Tilting tilted_marker(const Marker& marker, const TiltSettings& settings) {
  SumCache sums;
  const auto result = tilt(marker, settings, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_TRUE(make_marker(result->marker));  // with every tilt within its shape's limit
  EXPECT_LE(result->length_after, result->length_compacted);
  EXPECT_EQ(result->length_after, length_of(result->marker));
  return *result;
}

// A single bar between the strip's edges, tilted as far as they allow.
Marker leaning_bar(double degrees) {
  Layout layout{150'000};
  const auto bar = layout.shape_of(test::rectangle(400'000, 100'000));
  layout.put(bar, {20'000, 22'000});
  Marker marker = layout.marker();
  marker.shapes[0].tilt_limit = Angle::of_degrees(5);
  marker.pieces[0].orientation.tilt = Angle::of_degrees(degrees);
  return marker;
}

TEST(Tilt, UnplacedPiecesKeepTheirTilts) {
  Marker marker = leaning_bar(0);
  marker.unplaced = {marker.pieces[0]};
  marker.unplaced[0].id = "later";
  marker.unplaced[0].at = {};
  marker.unplaced[0].orientation.tilt = Angle::of_degrees(3);
  const Tilting tilting = tilted_marker(marker, limited(1));
  EXPECT_EQ(tilting.marker.unplaced, marker.unplaced);
}

// Two upright wedges that need 470 mm untilted, and about 435 mm when the right one is tilted by two degrees against
// the left one's slanted side.
Marker wedges(double limit) {
  Layout layout{1'100'000};
  const auto left = layout.shape_of({{0, 0}, {300'000, 0}, {335'000, 1'000'000}, {0, 1'000'000}});
  const auto right = layout.shape_of({{0, 0}, {135'000, 0}, {100'000, 1'000'000}, {0, 1'000'000}});
  layout.put(left, {0, 0}).put(right, {335'000, 50'000});
  Marker marker = layout.marker();
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
  return marker;
}

TEST(Tilt, ABarBetweenTheEdgesIsStraightened) {
  const Marker marker = leaning_bar(3);
  for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
    const Tilting result = tilted_marker(marker, settings_of(method));
    EXPECT_GT(result.length_compacted, 404'000);
    EXPECT_GE(result.length_after, 400'000);
    EXPECT_LE(result.length_after, method == TiltMethod::kLinearisation ? 400'010 : 402'000);
  }
}

TEST(Tilt, AWedgeLeansOnAWedge) {
  const Tilting result = tilted_marker(wedges(3), settings_of(TiltMethod::kLinearisation));
  EXPECT_EQ(result.length_compacted, 470'000);
  EXPECT_LT(result.length_after, 436'000);
  const double between =
      result.marker.pieces[0].orientation.tilt.degrees - result.marker.pieces[1].orientation.tilt.degrees;
  EXPECT_NEAR(between, 2.0, 0.1);
}

TEST(Tilt, LimitsHoldExactly) {
  for (const double limit : {0.1, 0.3, 0.7, 1.0 / 3}) {
    const Tilting own = tilted_marker(wedges(limit), settings_of(TiltMethod::kLinearisation));
    EXPECT_LE(own.farthest_tilt.degrees, limit);
    EXPECT_GT(own.farthest_tilt.degrees, 0.99 * limit);
    const Tilting given = tilted_marker(wedges(45), limited(limit));
    EXPECT_EQ(given.marker.pieces, own.marker.pieces);
    EXPECT_EQ(given.marker.shapes[0].tilt_limit, Angle::of_degrees(limit));
    EXPECT_LE(tilted_marker(wedges(0), limited(limit, TiltMethod::kRelaxation)).farthest_tilt.degrees, limit);
  }
}

TEST(Tilt, WithoutALimitItIsCompaction) {
  Marker marker = test::loose_marker(7);
  SumCache sums;
  const auto compaction = compact(marker, compaction_settings(compaction::Accuracy::kStandard), {sums});
  ASSERT_TRUE(compaction);
  for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
    const Tilting result = tilted_marker(marker, settings_of(method));
    EXPECT_LE(result.length_after, compaction->length_after);
    EXPECT_EQ(result.farthest_tilt, Angle{});
  }
}

TEST(Tilt, PiecesBeyondTheLimitAreNotTiltedFarther) {
  const Marker marker = leaning_bar(3);
  const Tilting result = tilted_marker(marker, limited(1));
  EXPECT_LE(result.farthest_tilt.degrees, 3.0);
  EXPECT_LE(result.length_after, 400'010);  // but back they may
}

TEST(Tilt, PiecesBeyondTheLimitDoNotRaiseItForOthers) {
  Marker marker = wedges(3);
  Piece beyond = marker.pieces[1];
  beyond.id = "beyond";
  beyond.at.x = 600'000;  // behind the one that would lean
  beyond.orientation.tilt = Angle::of_degrees(3);
  marker.pieces.push_back(beyond);
  for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
    const Tilting result = tilted_marker(marker, limited(0.5, method));
    for (const std::size_t k : {0U, 1U}) EXPECT_LE(std::abs(result.marker.pieces[k].orientation.tilt.degrees), 0.5);
    EXPECT_LE(std::abs(result.marker.pieces[2].orientation.tilt.degrees), 3);
  }
}

TEST(Tilt, LockedPiecesKeepPlaceAndTilt) {
  Marker marker = wedges(3);
  marker.pieces[1].locked = true;
  marker.pieces[1].orientation.tilt = Angle::of_degrees(0.25);
  marker.pieces[1].at.x += 10'000;
  for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
    const Tilting result = tilted_marker(marker, settings_of(method));
    EXPECT_EQ(result.marker.pieces[1], marker.pieces[1]);
  }
}

TEST(Tilt, EveryPieceIsItsOriginalShapeRoundedOnce) {
  Marker marker = test::loose_marker(11, 4, 2);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(3);
  const Tilting result = tilted_marker(marker, settings_of(TiltMethod::kLinearisation));
  ASSERT_GT(result.rounds, 3);
  ASSERT_GT(result.farthest_tilt.degrees, 0);
  EXPECT_EQ(result.marker.shapes, marker.shapes);
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const Piece& before = marker.pieces[i];
    const Piece& after = result.marker.pieces[i];
    EXPECT_EQ(std::tie(after.id, after.shape, after.orientation.flip, after.orientation.rotation),
              std::tie(before.id, before.shape, before.orientation.flip, before.orientation.rotation));
    // After any number of rounds, every vertex lies within half a unit of the position to which a single rotation moves
    // the original vertex.
    const Polygon outline = placed_outline(result.marker, PieceId{i});
    const Polygon& shape = marker.shapes[after.shape.value].outline;
    ASSERT_EQ(outline.size(), shape.size());
    const double angle =
        (after.orientation.rotation.degrees + after.orientation.tilt.degrees) * 3.141592653589793 / 180;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const auto x = static_cast<double>(shape[k].x);
      const auto y = static_cast<double>(shape[k].y);
      const Vec v = outline[k] - after.at;
      EXPECT_NEAR(static_cast<double>(v.x), x * std::cos(angle) - y * std::sin(angle), 0.501);
      EXPECT_NEAR(static_cast<double>(v.y), x * std::sin(angle) + y * std::cos(angle), 0.501);
    }
  }
}

TEST(Tilt, PerturbationsNeverMakeItLonger) {
  Marker marker = test::loose_marker(3, 3, 2);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(3);
  TiltSettings settings = settings_of(TiltMethod::kLinearisation);
  const Tilting once = tilted_marker(marker, settings);
  settings.perturbations = 3;
  const Tilting perturbed = tilted_marker(marker, settings);
  EXPECT_LE(perturbed.length_after, once.length_after);
  EXPECT_GT(perturbed.rounds, once.rounds);
}

TEST(Tilt, ReturnsTheBestSoFarWhenCancelled) {
  const Marker marker = wedges(3);
  SumCache sums;
  std::stop_source source;
  scene::Observer observer;
  int tilt_rounds = 0;
  observer.on_round = [&](const scene::Round& round) {
    if (round.length < 470'000 && ++tilt_rounds == 2) source.request_stop();
  };
  TiltSettings settings = settings_of(TiltMethod::kLinearisation);
  settings.step = Angle::of_degrees(0.25);
  const auto result = tilt(marker, settings, {sums, source.get_token(), observer});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LT(result->length_after, 470'000);
  EXPECT_GT(result->length_after, 440'000);  // two degrees take eight rounds
  settings.rounds = 1;
  EXPECT_EQ(tilted_marker(marker, settings).reason, scene::StopReason::kWorkLimit);
}

TEST(Tilt, TheAnswerDoesNotDependOnTheCache) {
  Marker marker = test::loose_marker(5, 4, 2);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(2);
  for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
    SumCache cold;
    SumCache small{1};
    const auto first = tilt(marker, settings_of(method), {cold});
    const auto warm = tilt(marker, settings_of(method), {cold});
    const auto forgetful = tilt(marker, settings_of(method), {small});
    ASSERT_TRUE(first && warm && forgetful);
    EXPECT_EQ(first->marker, warm->marker);
    EXPECT_EQ(first->marker, forgetful->marker);
  }
}

TEST(Tilt, RefusesInvalidLimits) {
  SumCache sums;
  for (const double degrees : {-1.0, 46.0, std::nan(""), 1 / 0.0}) {
    const auto result = tilt(wedges(1), limited(degrees), {sums});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kOutOfRange);
    EXPECT_EQ(result.error().field, "/limit");
  }
}

TEST(TiltedPiece, KeepsItsPivot) {
  const Marker marker = leaning_bar(0);
  const marker::PlacedPieces pieces{marker};
  Marker turned_marker = marker;
  turned_marker.pieces[0] = piece::tilted(marker.pieces[0], pieces[0], Angle::of_degrees(4));
  const RealVec before = model::tilting::pivot_of(pieces[0]);
  const RealVec after = model::tilting::pivot_of(marker::PlacedPieces{turned_marker}[0]);
  EXPECT_NEAR(before.x, after.x, 1.01);
  EXPECT_NEAR(before.y, after.y, 1.01);
}

RC_GTEST_PROP(TiltLaws, ValidNeverLongerLimitsAndLocksHold, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const auto columns = *rc::gen::inRange(1, 5);
  // At the smallest scale there is nothing but rounding.
  const Coord radius = *rc::gen::element<Coord>(30, 100'000, 10'000'000'000);
  Marker marker = test::loose_marker(seed, columns, *rc::gen::inRange(1, 4), radius);
  const double limit = 0.01 * *rc::gen::inRange(0, 500);
  for (Shape& shape : marker.shapes) shape.tilt_limit = Angle::of_degrees(limit);
  const auto every = *rc::gen::inRange<std::size_t>(2, 9);
  for (std::size_t k = 1; k < marker.pieces.size(); k += every) marker.pieces[k].locked = true;
  if (*rc::gen::arbitrary<bool>()) marker.spacing = 1 + marker.strip.width / *rc::gen::inRange<Coord>(500, 5000);
  RC_PRE(is_valid(marker));
  TiltSettings settings = settings_of(*rc::gen::element(TiltMethod::kLinearisation, TiltMethod::kRelaxation));
  settings.rounds = 6;
  settings.tilts = 3;
  settings.perturbations = *rc::gen::inRange(0, 2);
  SumCache sums;
  const auto result = tilt(marker, settings, {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(static_cast<bool>(make_marker(result->marker)));
  RC_ASSERT(result->length_after <= result->length_compacted);
  RC_ASSERT(result->length_compacted <= result->length_before);
  RC_ASSERT(result->farthest_tilt.degrees <= limit);
  RC_ASSERT(result->marker.shapes == marker.shapes);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    if (marker.pieces[k].locked) RC_ASSERT(result->marker.pieces[k] == marker.pieces[k]);
  }
}

}  // namespace
}  // namespace selvage::motion::tilting
