// Tests of outward simplification (core/outline/outward.h): known cases, and the laws of its header on random polygons.
#include "core/outline/outward.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

double distance_to_segment(RealVec point, Vec from, Vec to) {
  const double x = static_cast<double>(to.x - from.x);
  const double y = static_cast<double>(to.y - from.y);
  const double px = point.x - static_cast<double>(from.x);
  const double py = point.y - static_cast<double>(from.y);
  const double along = std::clamp((px * x + py * y) / (x * x + y * y), 0.0, 1.0);
  return std::hypot(px - along * x, py - along * y);
}
double distance_to_boundary(RealVec point, const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}
// The largest distance of sampled points of the first boundary from the second.
double farthest(const Polygon& polygon, const Polygon& from) {
  constexpr int kPoints = 16;
  double most = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i];
    const Vec way = polygon[(i + 1) % polygon.size()] - a;
    for (int k = 0; k < kPoints; ++k) {
      const double part = static_cast<double>(k) / kPoints;
      const RealVec point{static_cast<double>(a.x) + part * static_cast<double>(way.x),
                          static_cast<double>(a.y) + part * static_cast<double>(way.y)};
      most = std::max(most, distance_to_boundary(point, from));
    }
  }
  return most;
}

// The name of a law that is violated; empty when all laws hold.
std::string broken_law(const Polygon& given, Coord tolerance) {
  const Polygon grown = outline::simplified_outward(given, tolerance);
  const auto clean = clean_polygon(grown);
  if (!clean) return "not a polygon: " + clean.error().message;
  if (clean->repairs != geometry::Repairs{}) return "redundant vertices, or clockwise";
  if (!is_simple_exactly(grown)) return "not simple";
  if (!holds(grown, given)) return "does not contain the given polygon";
  if (grown.size() > given.size()) return "more vertices";
  if (grown.size() == given.size() && grown != given) return "a different polygon with as many vertices";
  if (farthest(grown, given) > static_cast<double>(tolerance) * (1 + 1e-9)) return "too far away";
  if (outline::simplified_outward(given, tolerance) != grown) return "not deterministic";
  return "";
}

TEST(Outward, SimplifiesKnownShapes) {
  const Polygon square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  EXPECT_EQ(outline::simplified_outward(square, 10), square);
  // A shallow notch is filled, a deep one remains.
  EXPECT_EQ(outline::simplified_outward({{0, 0}, {50, 3}, {100, 0}, {100, 100}, {0, 100}}, 10), square);
  const Polygon notched{{0, 0}, {50, 30}, {100, 0}, {100, 100}, {0, 100}};
  EXPECT_EQ(outline::simplified_outward(notched, 10), notched);
  // A bevelled corner becomes a point.
  EXPECT_EQ(outline::simplified_outward({{0, 0}, {96, 0}, {100, 4}, {100, 100}, {0, 100}}, 10), square);
  EXPECT_EQ(outline::simplified_outward({{0, 0}, {96, 0}, {100, 4}, {100, 100}, {0, 100}}, 2),
            (Polygon{{0, 0}, {96, 0}, {100, 4}, {100, 100}, {0, 100}}));
}

TEST(Outward, KeepsANotchThatAnotherPartReachesInto) {
  const Polygon open{{0, 0}, {40, 0}, {50, 6}, {60, 0}, {80, 0}, {80, 100}, {0, 100}};
  EXPECT_EQ(outline::simplified_outward(open, 10).size(), 4U);
  // The same shape with an arm that reaches around, so that its tip lies in the notch.
  const Polygon entered{{0, 0},  {40, 0},   {50, 6},  {60, 0},  {80, 0},    {80, -20},  {52, -20},
                        {50, 3}, {48, -20}, {0, -20}, {0, -40}, {120, -40}, {120, 100}, {0, 100}};
  ASSERT_TRUE(clean_polygon(entered));
  EXPECT_EQ(broken_law(entered, 10), "");
  const Polygon grown = outline::simplified_outward(entered, 10);
  EXPECT_NE(std::find(grown.begin(), grown.end(), Vec{50, 6}), grown.end());
}

TEST(Outward, SatisfiesItsLaws) {
  Random random{81};
  std::size_t fewer = 0;
  const int trials = 3000 / kSlowdown;
  for (int trial = 0; trial < trials; ++trial) {
    constexpr std::array<Coord, 4> kExtents{12, 1000, 1'000'000, kLatticeLimit / 2};
    const Coord extent = kExtents[random.below(kExtents.size())];
    const Polygon polygon = transformed(random_polygon(random, extent), random.symmetry());
    const Coord tolerance = random.between(1, std::max<Coord>(2, extent / random.between(2, 1000)));
    ASSERT_EQ(broken_law(polygon, tolerance), "") << tolerance << ": " << text_of(polygon);
    fewer += outline::simplified_outward(polygon, tolerance).size() < polygon.size() ? 1U : 0U;
  }
  EXPECT_GT(fewer, static_cast<std::size_t>(trials) / 3);
}

// Rounded corners and wavy edges are the main use of the simplification.
TEST(Outward, ReducesAFineCircleToAFewVertices) {
  Polygon circle;
  constexpr int kCorners = 400;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * 3.141592653589793 * k / kCorners;
    circle.push_back({std::llround(1e6 * std::cos(angle)), std::llround(1e6 * std::sin(angle))});
  }
  EXPECT_EQ(broken_law(circle, 5000), "");
  // A regular polygon with 32 corners around a circle extends five thousandths of the radius beyond it.
  EXPECT_LE(outline::simplified_outward(circle, 5000).size(), 64U);
}

}  // namespace
}  // namespace selvage::test
