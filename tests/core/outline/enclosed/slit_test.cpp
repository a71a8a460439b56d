#include "core/outline/enclosed/slit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "core/geometry/orientation.h"

namespace selvage::outline::enclosed {
namespace {

constexpr Coord kUnit = 1000;

Polygon box(Coord low_x, Coord low_y, Coord high_x, Coord high_y) {
  return {{low_x * kUnit, low_y * kUnit},
          {high_x * kUnit, low_y * kUnit},
          {high_x * kUnit, high_y * kUnit},
          {low_x * kUnit, high_y * kUnit}};
}
// Starting at the smallest corner.
Polygon normal(Polygon polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}
double area(const Polygon& polygon) {
  return geometry::area_of(polygon);
}

TEST(Slit, JoinsAHoleToTheOutside) {
  const auto open = with_open_holes(box(0, 0, 100, 100), {box(20, 20, 80, 80)});
  ASSERT_TRUE(open);
  EXPECT_EQ(open->size(), 10U);
  EXPECT_EQ(clean_polygon(*open)->repairs, geometry::Repairs{});
  EXPECT_EQ(locate({50 * kUnit, 50 * kUnit}, *open), geometry::Location::kOutside);
  EXPECT_EQ(locate({10 * kUnit, 50 * kUnit}, *open), geometry::Location::kInside);
  const double lost = area(box(0, 0, 100, 100)) - area(box(20, 20, 80, 80)) - area(*open);
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, 2.0 * kSlit * 30 * kUnit);
}

TEST(Slit, IsNotMadeToAHoleThatTouchesOrLeavesTheOutline) {
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {box(0, 20, 80, 80)}));
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {box(-20, 20, 80, 80)}));
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {box(120, 20, 180, 80)}));
}

TEST(Slit, IsNotMadeToHolesThatCrossOrContainEachOther) {
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {box(20, 20, 60, 60), box(40, 40, 80, 80)}));
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {box(20, 20, 80, 80), box(40, 40, 60, 60)}));
}

TEST(Slit, IsNotMadeToAHoleThatIsHardlyWider) {
  const Polygon tiny{{50'000, 50'000}, {50'100, 50'000}, {50'100, 50'100}, {50'000, 50'100}};
  EXPECT_FALSE(with_open_holes(box(0, 0, 100, 100), {tiny}));
}

TEST(Slit, IsNotSeenInANotch) {
  const Polygon notched{{0, 0}, {9'000, 0}, {9'000, 9'000}, {4'504, 9'000}, {4'502, 4'000}, {4'500, 9'000}, {0, 9'000}};
  EXPECT_EQ(without_slits(notched).outline, notched);
  EXPECT_TRUE(without_slits(notched).holes.empty());
}

RC_GTEST_PROP(SlitLaws, ReversesAlsoWhenTurnedAndRounded, ()) {
  // Up to four holes, each in a quarter of the outline.
  Polygon outline = box(0, 0, 100, 100);
  outline[2] = {*rc::gen::inRange<Coord>(96'000, 140'000), *rc::gen::inRange<Coord>(96'000, 140'000)};
  std::vector<Polygon> holes;
  for (const Vec corner : {Vec{0, 0}, Vec{45'000, 0}, Vec{0, 45'000}, Vec{45'000, 45'000}}) {
    if (*rc::gen::inRange(0, 3) == 0) continue;
    const auto between = [](Coord low, Coord high) { return *rc::gen::inRange<Coord>(low, high); };
    const auto clean = clean_polygon(Polygon{corner + Vec{between(3'000, 10'000), between(3'000, 10'000)},
                                             corner + Vec{between(20'000, 40'000), between(3'000, 15'000)},
                                             corner + Vec{between(20'000, 40'000), between(20'000, 40'000)},
                                             corner + Vec{between(3'000, 15'000), between(20'000, 40'000)}});
    if (clean) holes.push_back(clean->polygon);
  }
  const auto open = with_open_holes(outline, holes);
  RC_ASSERT(open.has_value());
  const Rings rings = without_slits(*open);
  RC_ASSERT(normal(rings.outline) == normal(outline));
  RC_ASSERT(rings.holes.size() == holes.size());
  for (const Polygon& hole : holes) {
    RC_ASSERT(std::any_of(rings.holes.begin(), rings.holes.end(),
                          [&](const Polygon& found) { return normal(found) == normal(hole); }));
  }
  Orientation turn;
  turn.flip = *rc::gen::arbitrary<bool>();
  turn.rotation = Angle::of_degrees(*rc::gen::inRange(0, 360));
  const Polygon turned = oriented(*open, turn);
  RC_ASSERT(static_cast<bool>(clean_polygon(turned)));
  RC_ASSERT(without_slits(turned).holes.size() == holes.size());
}

}  // namespace
}  // namespace selvage::outline::enclosed
