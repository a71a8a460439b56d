#include "core/packing/cores/coarsening.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/packing/contain.h"
#include "core/packing/cores/common_part.h"
#include "tests/core/motion/markers.h"
#include "tests/laws/random_marker.h"

namespace selvage::packing::cores {
namespace {

const Polygon kCuff{{0, 0}, {30'000, 0}, {28'000, 10'000}, {2'000, 10'000}};

// Two cuffs of one size and one that is larger, each of which may be turned by 180 degrees.
Marker three_cuffs() {
  test::Layout layout{100'000};
  Polygon larger = kCuff;
  for (Vec& corner : larger) corner = {corner.x + corner.x / 100, corner.y + corner.y / 100};
  layout.put(layout.shape_of(kCuff), {0, 0}).put(0, {0, 20'000}).put(layout.shape_of(larger), {0, 40'000});
  Marker marker = layout.marker();
  for (Shape& shape : marker.shapes) shape.rotations = {Angle{}, Angle::of_degrees(180)};
  return marker;
}

const std::vector<bool> kAll{true, true, true};

TEST(Coarsened, NearlyEqualPiecesHaveOneCoreWithoutOrientations) {
  const auto cores = coarsened(three_cuffs(), kAll, true, 0.8);
  ASSERT_TRUE(cores);
  const Shape& core = cores->shapes[cores->pieces[0].shape.value];
  EXPECT_EQ(cores->pieces[1].shape, cores->pieces[0].shape);
  EXPECT_EQ(cores->pieces[2].shape, cores->pieces[0].shape);
  EXPECT_EQ(core.rotations, std::vector{Angle{}});
  EXPECT_LT(doubled_area(core.outline), doubled_area(kCuff));
  EXPECT_GE(box_of(core.outline).height(), 9'980);
}

TEST(Coarsened, AShareThatOrientationsDoNotHaveKeepsThem) {
  const auto cores = coarsened(three_cuffs(), kAll, true, 0.97);
  ASSERT_TRUE(cores);
  EXPECT_EQ(cores->pieces[2].shape, cores->pieces[0].shape);
  EXPECT_EQ(cores->shapes[cores->pieces[0].shape.value].rotations.size(), 2);
}

TEST(Coarsened, ThereIsNoneWhereSizesDiffer) {
  EXPECT_FALSE(coarsened(three_cuffs(), kAll, true, 0.99));
}

TEST(Coarsened, PiecesThatStayOrHaveRulesAreLeftAsTheyAre) {
  Marker marker = three_cuffs();
  marker.pieces[0].rules.to = 90'000;
  marker.pieces[1].locked.x = true;
  EXPECT_FALSE(coarsened(marker, {true, true, false}, true, 0.95));
  const auto cores = coarsened(marker, kAll, true, 0.8);
  ASSERT_TRUE(cores);
  EXPECT_EQ(cores->pieces[0], marker.pieces[0]);
  EXPECT_EQ(cores->pieces[1], marker.pieces[1]);
}

// Without turns, a piece that is upside down has a core of its own.
TEST(Coarsened, WithoutTurnsPiecesKeepTheirOrientations) {
  Marker marker = three_cuffs();
  marker.pieces[2].orientation.rotation = Angle::of_degrees(180);
  EXPECT_FALSE(coarsened(marker, kAll, false, 0.97));
  const auto cores = coarsened(marker, {true, true, true}, false, 0.8);
  ASSERT_TRUE(cores);
  EXPECT_EQ(cores->pieces[2].shape, cores->pieces[0].shape);
}

// A piece that may only lie upside down is placed so, however it lies now.
TEST(Coarsened, CoresOfPiecesWithOneOrientationLieInIt) {
  Marker marker = three_cuffs();
  for (Shape& shape : marker.shapes) shape.rotations = {Angle::of_degrees(180)};
  const auto cores = coarsened(marker, kAll, true, 0.8);
  ASSERT_TRUE(cores);
  const Shape& core = cores->shapes[cores->pieces[0].shape.value];
  EXPECT_TRUE(lies_within(core.outline, oriented(kCuff, {false, Angle::of_degrees(180), {}})));
}

// Where pieces fit, their cores do.
TEST(CoarsenedLaws, CoresFitWherePiecesDo) {
  test::Random random{77};
  int changed = 0;
  for (int trial = 0; trial < 150 / test::kSlowdown + 20; ++trial) {
    SCOPED_TRACE(trial);
    const Marker valid = test::random_marker(random);
    std::vector<bool> moving;
    std::vector<PieceId> pieces;
    for (std::uint32_t k = 0; k < valid.pieces.size(); ++k) {
      moving.push_back(!valid.pieces[k].locked && random.below(2) == 0);
      if (moving.back()) pieces.push_back({k});
    }
    const auto cores = coarsened(valid, moving, true, 0.5);
    if (!cores) continue;
    ++changed;
    SumCache sums;
    ContainSettings settings;
    settings.limits.nodes = 2'000;
    const Box room = room_until(valid.strip, length_of(valid));
    EXPECT_NE(contain(*cores, pieces, room, settings, {sums}).verdict, Verdict::kImpossible);
  }
  EXPECT_GT(changed, 20 / test::kSlowdown);
}

}  // namespace
}  // namespace selvage::packing::cores
