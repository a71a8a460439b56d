#include "core/motion/compaction/open_gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/marker/validity.h"
#include "tests/core/motion/markers.h"
#include "tests/support/garment.h"

namespace selvage::motion::compaction {
namespace {

using test::Layout;

const CompactionSettings kSettings = compaction_settings(Accuracy::kStandard);
constexpr marker::UnoccupiedSettings kEverything{0, 0};
constexpr Coord k1 = 10'000;  // lattice units

double area_in_k1(const marker::UnoccupiedRegion& region) {
  return region.area / static_cast<double>(k1 * k1);
}

// Opens a gap and checks what must hold for every opening.
OpenedGap opened(const Marker& marker, const GapChoice& choice, const marker::UnoccupiedSettings& regions) {
  SumCache sums;
  const auto result = open_gap(marker, choice, kSettings, regions, {sums});
  EXPECT_TRUE(result) << result.error().message;
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before);
  EXPECT_GE(result->after.area, result->before.area);
  EXPECT_NE(locate(result->inside, result->before.region), geometry::Location::kOutside);
  EXPECT_NE(locate(result->inside, result->after.region), geometry::Location::kOutside);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    if (!marker.pieces[k].locked) continue;
    EXPECT_EQ(result->marker.pieces[k].at, marker.pieces[k].at);
  }
  return *result;
}

// Two walls with a gap between them, and room behind each [Li94 Figure 4.7 lying down].
test::Layout walls(bool first_locked) {
  test::Layout layout{1000 * k1};
  const auto wall = layout.shape_of(test::rectangle(100 * k1, 1000 * k1));
  layout.put(wall, {200 * k1, 0}, 0, first_locked).put(wall, {500 * k1, 0}).put(wall, {900 * k1, 0}, 0, true);
  return layout;
}

TEST(OpenGap, PushesTheWallsApart) {
  const OpenedGap by_point = opened(walls(false).marker(), AwayFromPoint{{400 * k1, 500 * k1}}, kEverything);
  EXPECT_NEAR(area_in_k1(by_point.before), 200 * 1000, 1);
  EXPECT_NEAR(area_in_k1(by_point.after), 700 * 1000, 1);
  EXPECT_EQ(by_point.marker.pieces[0].at, (Vec{0, 0}));
  EXPECT_EQ(by_point.marker.pieces[1].at, (Vec{800 * k1, 0}));
  EXPECT_EQ(by_point.reason, scene::StopReason::kConverged);
  const OpenedGap by_outline = opened(walls(false).marker(), AwayFromOutline{1}, kEverything);
  EXPECT_EQ(by_outline.marker, by_point.marker);
  EXPECT_EQ(by_outline.after, by_point.after);
}

TEST(OpenGap, LocksHold) {
  const OpenedGap gap = opened(walls(true).marker(), AwayFromPoint{{400 * k1, 500 * k1}}, kEverything);
  EXPECT_NEAR(area_in_k1(gap.after), 500 * 1000, 1);
}

TEST(OpenGap, AlsoEndsWithoutAMinimumGain) {
  CompactionSettings settings = kSettings;
  settings.least_gain = 0;
  SumCache sums;
  const auto result = open_gap(walls(false).marker(), AwayFromOutline{1}, settings, kEverything, {sums});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kConverged);
  EXPECT_NEAR(area_in_k1(result->after), 700 * 1000, 1);
}

TEST(OpenGap, MovesNothingWhereNothingCanOpen) {  // a frame of bricks without slack
  Layout layout{300 * k1};
  const auto brick = layout.shape_of(test::rectangle(200 * k1, 100 * k1));
  const auto post = layout.shape_of(test::rectangle(100 * k1, 200 * k1));
  layout.put(brick, {0, 0}).put(post, {200 * k1, 0}).put(brick, {100 * k1, 200 * k1}).put(post, {0, 100 * k1});
  for (const GapChoice& choice : {GapChoice{AwayFromPoint{{150 * k1, 150 * k1}}}, GapChoice{AwayFromOutline{0}}}) {
    const OpenedGap gap = opened(layout.marker(), choice, kEverything);
    EXPECT_EQ(gap.marker, layout.marker());
    EXPECT_EQ(gap.before, gap.after);
    EXPECT_NEAR(area_in_k1(gap.before), 100 * 100, 1);
    EXPECT_EQ(gap.reason, scene::StopReason::kConverged);
    EXPECT_EQ(gap.rounds, 0);
  }
}

TEST(OpenGap, RefusesPointsThatAreNotInAGap) {
  SumCache sums;
  const Marker marker = walls(false).marker();
  EXPECT_EQ(open_gap(marker, AwayFromPoint{{250 * k1, 500 * k1}}, kSettings, kEverything, {sums}).error().field,
            "/point");
  EXPECT_EQ(open_gap(marker, AwayFromOutline{3}, kSettings, kEverything, {sums}).error().field, "/region");
  EXPECT_EQ(open_gap(marker, AwayFromOutline{3}, kSettings, kEverything, {sums}).error().code, ErrorCode::kOutOfRange);
}

// Repair closes the slit before the second wall, so the list of regions becomes shorter.
TEST(OpenGap, RegionsAreNumberedAsInTheInput) {
  Layout layout{1000 * k1};
  const auto wall = layout.shape_of(test::rectangle(100 * k1, 1000 * k1));
  layout.put(wall, {0, 0}, 0, true).put(wall, {100 * k1 + 100, 0});
  layout.put(wall, {200 * k1, 0}, 0, true).put(wall, {900 * k1, 0}, 0, true);
  const Marker marker = layout.marker();
  ASSERT_EQ(unoccupied_regions(marker, kEverything).size(), 2U);
  const OpenedGap gap = opened(marker, AwayFromOutline{1}, kEverything);
  EXPECT_EQ(gap.repair.pairs, 1U);
  EXPECT_NEAR(area_in_k1(gap.before), 600 * 1000, 1);
  SumCache sums;
  EXPECT_EQ(open_gap(marker, AwayFromOutline{0}, kSettings, kEverything, {sums}).error().code, ErrorCode::kOutOfRange);
}

TEST(OpenGap, ReportsThatItWasCancelledBeforeItFoundTheGap) {
  SumCache sums;
  std::stop_source source;
  source.request_stop();
  for (const GapChoice& choice : {GapChoice{AwayFromPoint{{150 * k1, 500 * k1}}}, GapChoice{AwayFromOutline{1}}}) {
    const auto result = open_gap(walls(false).marker(), choice, kSettings, kEverything, {sums, source.get_token()});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kStoppedEarly);
  }
}

TEST(OpenGap, CanBeCancelled) {
  SumCache sums;
  std::stop_source source;
  scene::Observer observer;
  observer.on_program = [&](const lp::LinearProgram&) { source.request_stop(); };
  const Marker marker = walls(false).marker();
  const auto result =
      open_gap(marker, AwayFromOutline{1}, kSettings, kEverything, {sums, source.get_token(), observer});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->reason, scene::StopReason::kCancelled);
  EXPECT_EQ(result->marker, marker);
}

class GarmentGaps : public ::testing::TestWithParam<const char*> {};

TEST_P(GarmentGaps, TheLargestGapGrows) {
  const Marker marker = test::garment(GetParam());
  const marker::UnoccupiedSettings settings = unoccupied_settings(marker.strip);
  const auto regions = unoccupied_regions(marker, settings);
  ASSERT_FALSE(regions.empty());
  const auto largest = std::max_element(
      regions.begin(), regions.end(),
      [](const marker::UnoccupiedRegion& a, const marker::UnoccupiedRegion& b) { return a.area < b.area; });
  const GapChoice outline = AwayFromOutline{static_cast<std::size_t>(largest - regions.begin())};
  const GapChoice point = AwayFromPoint{point_inside(largest->region)};
  for (const GapChoice& choice : {outline, point}) {
    const OpenedGap gap = opened(marker, choice, settings);
    EXPECT_GT(gap.after.area, gap.before.area);
    const char* const by = std::holds_alternative<AwayFromPoint>(choice) ? "point" : "outline";
    RecordProperty(std::string{by} + "_grows_by_permille",
                   static_cast<int>(1000 * (gap.after.area / gap.before.area - 1)));
    RecordProperty(std::string{by} + "_rounds", gap.rounds);
  }
}

INSTANTIATE_TEST_SUITE_P(All, GarmentGaps, test::kGarments, test::garment_name);

}  // namespace
}  // namespace selvage::motion::compaction
