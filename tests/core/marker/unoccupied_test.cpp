// Tests of core/marker/unoccupied.h: known layouts, and the areas left over in the garment markers, against CGAL.
#include "core/marker/unoccupied.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "tests/support/exact.h"
#include "tests/support/garment.h"

namespace selvage::marker {
namespace {

constexpr UnoccupiedSettings kEverything{0, 0};
constexpr Coord k1 = 1'000'000;  // lattice units

// Rectangles (x, y, width, height) on a strip 100 wide; all numbers in units of k1.
struct Rectangle {
  Coord x{}, y{}, width{}, height{};
};
Marker rectangles(const std::vector<Rectangle>& pieces) {
  Marker marker;
  marker.strip.width = 100 * k1;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    const Coord w = pieces[k].width * k1;
    const Coord h = pieces[k].height * k1;
    const std::string id = std::to_string(k);
    marker.shapes.push_back({.id = id, .outline = {{0, 0}, {w, 0}, {w, h}, {0, h}}, .tilt_limit = {}});
    const Vec at{pieces[k].x * k1, pieces[k].y * k1};
    marker.pieces.push_back({.id = id, .shape = ShapeId{k}, .orientation = {}, .at = at});
  }
  return marker;
}

constexpr double kNear = 1e-4;
double in_k1(double units) {
  return units / static_cast<double>(k1);
}
double area_in_k1(const UnoccupiedRegion& region) {
  return in_k1(in_k1(region.area));
}
double total_area(const std::vector<UnoccupiedRegion>& regions) {
  double area = 0;
  for (const UnoccupiedRegion& region : regions) area += region.area;
  return area;
}

TEST(Unoccupied, CanBeCancelled) {
  std::stop_source source;
  const Marker marker = rectangles({{0, 0, 10, 10}, {90, 0, 10, 10}});
  EXPECT_TRUE(unoccupied_regions(marker, kEverything, source.get_token()));
  source.request_stop();
  const auto stopped = unoccupied_regions(marker, kEverything, source.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kStoppedEarly);
}

TEST(Unoccupied, IsFoundBetweenTwoWalls) {  // pieces that span the strip divide the cloth in two; the last one ends it
  const auto regions =
      unoccupied_regions(rectangles({{0, 0, 10, 10}, {50, 0, 10, 100}, {90, 0, 10, 100}}), kEverything);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(area_in_k1(regions[0]), 50 * 100 - 100, 0.01);
  EXPECT_NEAR(area_in_k1(regions[1]), 30 * 100, 0.01);
  ASSERT_EQ(regions[0].around.size(), 2U);
  EXPECT_EQ(regions[0].around[0].piece, PieceId{0});
  // Moving a wall by one unit enlarges the region by the length of the wall.
  ASSERT_EQ(regions[1].around.size(), 2U);
  EXPECT_EQ(regions[1].around[0].piece, PieceId{1});
  EXPECT_NEAR(in_k1(regions[1].around[0].x), -100, kNear);
  EXPECT_NEAR(in_k1(regions[1].around[0].y), 0, kNear);
  EXPECT_EQ(regions[1].around[1].piece, PieceId{2});
  EXPECT_NEAR(in_k1(regions[1].around[1].x), 100, kNear);
}

TEST(Unoccupied, HasAHoleAroundAnIsland) {
  const auto regions = unoccupied_regions(rectangles({{40, 40, 10, 10}, {90, 0, 10, 10}}), kEverything);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(area_in_k1(regions[0]), 100 * 100 - 200, 0.01);
  EXPECT_EQ(regions[0].region.holes.size(), 1U);
  ASSERT_EQ(regions[0].around.size(), 2U);
  EXPECT_NEAR(in_k1(regions[0].around[0].x), 0,
              kNear);  // moving a piece that lies wholly inside does not change the area
  EXPECT_NEAR(in_k1(regions[0].around[0].y), 0, kNear);
}

TEST(Unoccupied, IsDividedByPiecesThatTouch) {  // corner to corner, across the whole strip
  const auto regions = unoccupied_regions(rectangles({{0, 0, 50, 50}, {50, 50, 50, 50}}), kEverything);
  ASSERT_EQ(regions.size(), 2U);
  for (const UnoccupiedRegion& region : regions) EXPECT_NEAR(area_in_k1(region), 2500, 0.01);
  const auto none = unoccupied_regions(rectangles({{0, 0, 50, 50}, {0, 50, 50, 50}}), kEverything);
  EXPECT_TRUE(none.empty());  // side by side, without cloth between them
}

TEST(Unoccupied, LeavesOutSmallRegions) {
  const Marker marker = rectangles({{0, 0, 30, 99}});
  EXPECT_EQ(unoccupied_regions(marker, {0.0029, 0}).size(), 1U);
  EXPECT_TRUE(unoccupied_regions(marker, {0.0031, 0}).empty());
}

TEST(Unoccupied, IsDividedByNarrowGaps) {  // a wall of two halves with a small gap
  const Marker marker = rectangles({{50, 0, 10, 49}, {50, 51, 10, 49}, {100, 0, 10, 10}});
  EXPECT_EQ(unoccupied_regions(marker, kEverything).size(), 1U);
  EXPECT_EQ(unoccupied_regions(marker, {0, 9 * k1 / 10}).size(), 1U);
  EXPECT_EQ(unoccupied_regions(marker, {0, 11 * k1 / 10}).size(), 2U);
}

class GarmentRegions : public ::testing::TestWithParam<const char*> {};

// The pieces of a valid marker do not overlap, so the regions' total area is that of the cloth without the pieces and
// the clearance around them.
TEST_P(GarmentRegions, CoverTheClothThatPiecesLeave) {
  const Marker marker = test::garment(GetParam());
  const double cloth = static_cast<double>(length_of(marker)) * static_cast<double>(marker.strip.width);
  double perimeter = 0;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const Polygon outline = placed_outline(marker, PieceId{i});
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec edge = outline[(k + 1) % outline.size()] - outline[k];
      perimeter += std::hypot(static_cast<double>(edge.x), static_cast<double>(edge.y));
    }
  }
  const double uncovered = (1 - utilisation_of(marker)) * cloth;
  const double area = total_area(unoccupied_regions(marker, kEverything));
  EXPECT_LT(area, uncovered);
  EXPECT_GT(area, uncovered - 1.1 * static_cast<double>(kLeastClearance) * perimeter);
}

// Each area compared with CGAL's exact set operations on the same grown outlines.
TEST_P(GarmentRegions, HaveTheExactAreas) {
  const Marker marker = test::garment(GetParam());
  const UnoccupiedSettings settings{0, unoccupied_settings(marker.strip).clearance};
  std::vector<Polygon> outlines;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const auto rings = outline::grown(placed_outline(marker, PieceId{i}), settings.clearance);
    ASSERT_EQ(rings.size(), 1U);
    outlines.push_back(rings.front());
  }
  const auto exact = test::areas_left_over({{0, 0}, {length_of(marker), marker.strip.width}}, outlines);
  std::vector<double> areas;
  for (const UnoccupiedRegion& region : unoccupied_regions(marker, settings)) areas.push_back(region.area);
  std::sort(areas.rbegin(), areas.rend());
  const double width = static_cast<double>(marker.strip.width);
  for (std::size_t k = 0; k < std::max(exact.size(), areas.size()); ++k) {
    EXPECT_NEAR(k < areas.size() ? areas[k] : 0, k < exact.size() ? exact[k] : 0, 1e-7 * width * width) << k;
  }
}

TEST_P(GarmentRegions, KeepTheirClearance) {
  const Marker marker = test::garment(GetParam());
  const UnoccupiedSettings settings = unoccupied_settings(marker.strip);
  const PlacedPieces pieces{marker};
  const auto regions = unoccupied_regions(marker, settings);
  ASSERT_FALSE(regions.empty());
  const double width = static_cast<double>(marker.strip.width);
  for (const UnoccupiedRegion& region : regions) {
    EXPECT_GE(region.area, settings.least_area * width * width);
    EXPECT_GE(region.around.size(), 1U);
    EXPECT_EQ(locate(point_inside(region.region), region.region), geometry::Location::kInside);
    for (const Vec v : region.region.outline) {
      const Polygon speck{v, {v.x + 1, v.y}, {v.x, v.y + 1}};
      const geometry::PlacedPolygon placed{speck, box_of(speck), {}};
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!pieces.box(i).grown(settings.clearance).touches(placed.box)) continue;
        ASSERT_FALSE(closer_than(placed, pieces[i], settings.clearance - 4)) << v.x << ' ' << v.y << ' ' << i;
      }
    }
  }
  EXPECT_EQ(regions, unoccupied_regions(marker, settings));
}

INSTANTIATE_TEST_SUITE_P(All, GarmentRegions, test::kGarments, test::garment_name);

}  // namespace
}  // namespace selvage::marker
