// Motions that model only the pieces within reach gain as much as with the naive model, which contains every piece,
// pair and row.
#include <gtest/gtest.h>

#include <cmath>

#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/open_gap.h"
#include "core/motion/compaction/push.h"
#include "core/motion/separation/separation_step.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/tiled_marker.h"

namespace selvage::motion::step {
namespace {

compaction::CompactionSettings settings_with(model::Extent extent) {
  compaction::CompactionSettings settings = compaction_settings(compaction::Accuracy::kStandard);
  settings.extent = extent;
  return settings;
}

// More pieces than the position step models completely, but few enough for the naive model.
constexpr std::size_t kPieces = 80;

// The total distance that pieces move in one round of separation.
double way_apart(const Marker& marker, Coord length, model::Extent extent) {
  SumCache sums;
  const scene::Scene scene{marker, sums};
  std::vector<separation::OverlappingPair> overlapping;
  for (const marker::PiecePair& pair : conflicts(scene.pieces)) {
    overlapping.push_back({pair, separation_target(scene, pair, repair::TargetRule::kNearest), 100});
  }
  const double reach = 0.05 * static_cast<double>(marker.strip.width);
  const separation::SeparationStepSettings settings{
      reach, 100, model::TightRows::kKeep, {length, length, 10, 50}, lp::solver::SolverChoice::kAutomatic, extent};
  const separation::SeparationStep step =
      separation_step(scene, overlapping, scene.pieces.positions(), settings, {sums});
  EXPECT_EQ(step.status, lp::LpStatus::kOptimal);
  double sum = 0;
  for (std::size_t i = 0; i < step.positions.size(); ++i) {
    const Vec by = step.positions[i] - scene.pieces.at(i);
    sum += static_cast<double>(std::abs(by.x) + std::abs(by.y));
  }
  return sum;
}

class GarmentExtents : public ::testing::TestWithParam<const char*> {
 protected:
  Marker marker_{test::tiled(test::garment(GetParam()), kPieces)};
  double width_{static_cast<double>(marker_.strip.width)};
};

TEST_P(GarmentExtents, CompactionComesToTheSameLength) {
  const Marker loose = test::loosened(marker_, 0.05);
  const auto length = [&](model::Extent extent) {
    SumCache sums;
    compaction::CompactionSettings settings = settings_with(extent);
    settings.rounds = 1;  // the same program: later rounds start where the first one's vertex lies
    settings.solver_tolerance = 0;
    return static_cast<double>(compact(loose, settings, {sums})->length_after);
  };
  EXPECT_NEAR(length(model::Extent::kActiveSet), length(model::Extent::kWhole), 1e-7 * width_);
}

TEST_P(GarmentExtents, PushingOnePieceGainsAsMuch) {
  const auto gain = [&](const compaction::Force& force, model::Extent extent) {
    SumCache sums;
    compaction::CompactionSettings settings = settings_with(extent);
    settings.rounds = 1;
    const auto pushed = push(marker_, {&force, 1}, settings, {sums});
    EXPECT_TRUE(is_valid(pushed->marker));
    return pushed->gain;
  };
  for (std::uint32_t piece = 3; piece < marker_.pieces.size(); piece += 16) {
    for (const RealVec to : {RealVec{1, 0}, {-1, 0}, {0, 1}, {0.6, -0.8}}) {
      const compaction::Force force{PieceId{piece}, to.x, to.y};
      // Pieces outside the reach stay and need no margins, so the result may be better by a few units, but never worse.
      EXPECT_NEAR(gain(force, model::Extent::kActiveSet), gain(force, model::Extent::kWhole), 1e-5 * width_)
          << piece << ' ' << to.x;
    }
  }
}

TEST_P(GarmentExtents, OpeningAGapGainsAsMuch) {
  const marker::UnoccupiedSettings regions = unoccupied_settings(marker_.strip);
  const std::size_t count = unoccupied_regions(marker_, regions).size();
  const auto area = [&](std::size_t region, model::Extent extent) {
    SumCache sums;
    compaction::CompactionSettings settings = settings_with(extent);
    settings.rounds = 1;
    const auto opened = open_gap(marker_, compaction::AwayFromOutline{region}, settings, regions, {sums});
    EXPECT_TRUE(is_valid(opened->marker));
    return opened->after.area;
  };
  for (std::size_t region = 0; region < count; region += 1 + count / 4) {
    const double whole = area(region, model::Extent::kWhole);
    EXPECT_NEAR(area(region, model::Extent::kActiveSet), whole, 1e-3 * whole) << region;
  }
}

TEST_P(GarmentExtents, SeparatingOnePieceMovesAsLittle) {
  for (std::size_t piece = 1; piece < marker_.pieces.size(); piece += 8) {
    if (marker::PlacedPieces{marker_}.box(piece).low.x < marker_.strip.width / 100) continue;
    Marker overlapping = marker_;
    overlapping.pieces[piece].at.x -= marker_.strip.width / 200;
    const Coord length = marker::PlacedPieces{overlapping}.length();
    EXPECT_NEAR(way_apart(overlapping, length, model::Extent::kActiveSet),
                way_apart(overlapping, length, model::Extent::kWhole), 1e-5 * width_)
        << piece;
  }
}

TEST(Extents, SeparationPushesAWholeRow) {
  test::Layout layout{1000};
  const auto square = layout.shape_of(test::rectangle(1000, 1000));
  layout.put(square, {0, 0});
  for (Coord k = 1; k < 40; ++k) layout.put(square, {1000 * k - 50, 0});
  for (const model::Extent extent : {model::Extent::kActiveSet, model::Extent::kWhole}) {
    EXPECT_NEAR(way_apart(layout.marker(), 40'000, extent), 39 * 50, 39);
  }
}

INSTANTIATE_TEST_SUITE_P(Garments, GarmentExtents, ::testing::Values("jeans_02g", "charlie_04g", "simon_06g"),
                         test::garment_name);

// A rhombus without room between two locked ones, and more free squares elsewhere than are modelled completely: there
// is no room for margins, and no piece within reach could make room.
TEST(Extents, EndsWhenThereIsNothingToReach) {
  constexpr Coord kSide = 1'000'000;
  Marker marker;
  marker.resolution = {-6};
  marker.strip.width = 10 * kSide;
  marker.shapes.push_back(
      {.id = "rhombus", .outline = {{0, 0}, {kSide, 0}, {2 * kSide, kSide}, {kSide, kSide}}, .tilt_limit = {}});
  marker.shapes.push_back(
      {.id = "square", .outline = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}, .tilt_limit = {}});
  for (Coord k = 0; k < 3; ++k) {
    const Locks locked{k != 1, k != 1, true};
    marker.pieces.push_back({.id = "r" + std::to_string(k),
                             .shape = {0},
                             .orientation = {},
                             .at = {k * kSide, 4 * kSide},
                             .locked = locked});
  }
  for (Coord k = 0; k < static_cast<Coord>(kPieces); ++k) {
    marker.pieces.push_back(
        {.id = "s" + std::to_string(k), .shape = {1}, .orientation = {}, .at = {(10 + 2 * k) * kSide, 4 * kSide}});
  }
  ASSERT_TRUE(is_valid(marker));
  SumCache sums;
  const scene::Scene scene{marker, sums};
  Goal goal{std::vector<RealVec>(scene.pieces.size()), 0, 1e-3};
  for (const RealVec force : {RealVec{0, 1}, RealVec{1, 0}}) {
    goal.force[1] = force;
    const PositionStep step = position_step(scene, goal, {0.05, {}, {}}, {sums});
    EXPECT_LE(step.programs, 4);
    EXPECT_EQ(step.positions.size(), step.end == StepEnd::kMoved ? scene.pieces.size() : 0);
  }
}

}  // namespace
}  // namespace selvage::motion::step
