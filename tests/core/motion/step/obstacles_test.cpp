// Programs made from simplified outlines.
#include "core/motion/step/obstacles.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"
#include "tests/support/tiled/digitised.h"

namespace selvage::motion::step {
namespace {

// Two combs facing each other, with `apart` units of room between them.
Marker combs(Coord apart) {
  test::Layout layout{2000};
  const auto comb = layout.shape_of({{0, 0}, {1000, 0}, {1000, 300}, {750, 290}, {500, 300}, {250, 290}, {0, 300}});
  return layout.put(comb, {0, 0}).put(comb, {0, 300 + apart}).marker();
}

std::size_t edges_between(const Marker& marker, double simplification) {
  SumCache sums;
  const scene::Scene scene{marker, sums};
  return Obstacles{scene, simplification}.of({0, 1}).sum().edges().size();
}

TEST(Obstacles, SimplifiesPairsThatAreApartAndNoOthers) {
  constexpr double kTenUnits = 0.005;
  const std::size_t own = edges_between(combs(100), 0);
  EXPECT_LT(edges_between(combs(100), kTenUnits), own);
  EXPECT_LT(edges_between(combs(10), kTenUnits), own);
  EXPECT_EQ(edges_between(combs(9), kTenUnits), own);
  EXPECT_EQ(edges_between(combs(0), kTenUnits), own);
}

TEST(Obstacles, IncludeTheSpacing) {
  Marker marker = combs(100);
  const std::size_t own = edges_between(marker, 0);
  marker.spacing = 90;
  EXPECT_LT(edges_between(marker, 0.005), own);
  marker.spacing = 91;
  EXPECT_EQ(edges_between(marker, 0.005), own);
}

// The answers are valid, not longer, and independent of the cache; and pieces that touch are not kept apart.
TEST(Obstacles, SimplifiedProgramsKeepTheLawsOfCompaction) {
  const Marker coarse = test::garment("jeans_02g");
  const Marker marker = test::digitised(coarse, coarse.strip.width / 100, coarse.strip.width / 10'000);
  ASSERT_TRUE(is_valid(marker));
  const auto rows_of_first_program = [&](const compaction::CompactionSettings& settings, compaction::Compaction& done,
                                         SumCache& sums) {
    int rows = 0;
    scene::Observer observer;
    observer.on_program = [&](const lp::LinearProgram& program) { rows = rows == 0 ? program.rows() : rows; };
    done = *compact(marker, settings, {sums, {}, observer});
    return rows;
  };
  compaction::CompactionSettings settings = compaction_settings(compaction::Accuracy::kStandard);
  compaction::Compaction own;
  SumCache fresh;
  const int own_rows = rows_of_first_program(settings, own, fresh);
  for (const double simplification : {2e-4, 1e-3, 1e-2}) {
    settings.simplification = simplification;
    SumCache sums;
    compaction::Compaction done;
    EXPECT_LT(rows_of_first_program(settings, done, sums), own_rows) << simplification;
    EXPECT_TRUE(is_valid(done.marker)) << simplification;
    EXPECT_LE(done.length_after, done.length_before) << simplification;
    EXPECT_LT(static_cast<double>(done.length_after), 1.0001 * static_cast<double>(own.length_after)) << simplification;
    EXPECT_EQ(compact(marker, settings, {sums})->marker, done.marker) << simplification;
    EXPECT_EQ(compact(marker, settings, {fresh})->marker, done.marker) << simplification;
  }
}

}  // namespace
}  // namespace selvage::motion::step
