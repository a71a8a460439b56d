#include "core/motion/compaction/push.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::compaction {
namespace {

using test::Layout;

const CompactionSettings kStandard = compaction_settings(Accuracy::kStandard);

Push pushed(const Marker& marker, const std::vector<Force>& forces) {
  SumCache sums;
  const auto result = push(marker, forces, kStandard, {sums});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result) return {};
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before);
  EXPECT_GE(result->gain, 0);
  return *result;
}

TEST(Push, MovesAPieceAndThePiecesInItsWay) {
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(100, 100));
  layout.put(square, {0, 450}).put(square, {150, 450}).put(square, {900, 0});
  const auto result = pushed(layout.marker(), {{PieceId{0}, 1, 0}});
  EXPECT_EQ(result.marker.pieces[0].at, (Vec{800, 450}));  // the second gives way to the marker's end
  EXPECT_EQ(result.marker.pieces[1].at, (Vec{900, 450}));
  EXPECT_EQ(result.marker.pieces[2].at, (Vec{900, 0}));  // not in the way
  EXPECT_EQ(result.length_after, 1000);
}

TEST(Push, SqueezesAPieceOutFromBetweenTwo) {  // [Li94 Figure 4.6]
  Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(300, 300));
  const auto wedge = layout.shape_of({{0, 0}, {200, -150}, {200, 150}});
  layout.put(square, {0, 200}).put(square, {0, 500}).put(wedge, {300, 500}).put(square, {700, 0});
  const auto result = pushed(layout.marker(), {{PieceId{2}, -1, 0}});
  EXPECT_LE(result.marker.pieces[2].at.x, 3);            // all the way in: the squares have room to part
  EXPECT_EQ(result.marker.pieces[3].at, (Vec{700, 0}));  // what is not in the way stays
}

TEST(Push, GravityGathersEverythingAtTheBottom) {
  const Marker marker = test::loose_marker(4);
  const auto result = pushed(marker, gravity(marker, 0, -3));
  EXPECT_GT(result.gain, 0);
  double before = 0;
  double after = 0;
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    before += static_cast<double>(marker.pieces[k].at.y);
    after += static_cast<double>(result.marker.pieces[k].at.y);
  }
  EXPECT_NEAR(before - after, result.gain, 1);
}

TEST(Push, WithoutForcesNothingMoves) {
  const Marker marker = test::loose_marker(4);
  EXPECT_EQ(pushed(marker, {}).marker, marker);
  EXPECT_EQ(pushed(marker, {{PieceId{0}, 0, 0}}).marker, marker);
}

TEST(Push, RefusesInvalidForces) {
  SumCache sums;
  const Marker marker = test::loose_marker(4);
  const std::vector<Force> nobody{{PieceId{99}, 1, 0}};
  EXPECT_EQ(push(marker, nobody, kStandard, {sums}).error().code, ErrorCode::kOutOfRange);
  const std::vector<Force> endless{{PieceId{0}, 1 / 0.0, 0}};
  EXPECT_EQ(push(marker, endless, kStandard, {sums}).error().field, "/forces/0");
}

}  // namespace
}  // namespace selvage::motion::compaction
