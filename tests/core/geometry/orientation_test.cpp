// Tests of core/geometry/orientation.h: exact symmetries, splitting of orientations, and rounding of turned polygons.
#include "core/geometry/orientation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

std::vector<Symmetry> all_symmetries() {
  std::vector<Symmetry> all;
  for (const bool flip : {false, true}) {
    for (int q = 0; q < 4; ++q) all.emplace_back(flip, q);
  }
  return all;
}

const Vec kAskew{5, 2};  // only the identity leaves it unchanged

TEST(Symmetries, ThereAreEight) {
  std::vector<Vec> images;
  for (const Symmetry s : all_symmetries()) {
    EXPECT_EQ(s.index(), static_cast<int>(images.size()));
    EXPECT_EQ(std::count(images.begin(), images.end(), s.apply(kAskew)), 0);
    images.push_back(s.apply(kAskew));
  }
}

TEST(Symmetries, MapKnownPoints) {
  EXPECT_EQ(Symmetry(false, 1).apply({1, 0}), (Vec{0, 1}));  // counter-clockwise
  EXPECT_EQ(Symmetry(true, 0).apply(kAskew), (Vec{5, -2}));  // the grain line is unchanged
  EXPECT_EQ(Symmetry(true, 1).apply({0, 1}), (Vec{1, 0}));   // flip first: (0,-1), then a quarter turn
  EXPECT_EQ(Symmetry(false, -1), Symmetry(false, 3));
  EXPECT_EQ(Symmetry(false, 7), Symmetry(false, 3));
}

TEST(Symmetries, FormAGroup) {
  const Symmetry identity;
  for (const Symmetry a : all_symmetries()) {
    EXPECT_EQ(a.after(identity), a);
    EXPECT_EQ(identity.after(a), a);
    EXPECT_EQ(a.after(a.inverse()), identity);
    EXPECT_EQ(a.inverse().after(a), identity);
    for (const Symmetry b : all_symmetries()) {
      EXPECT_EQ(a.after(b).apply(kAskew), a.apply(b.apply(kAskew)));
      EXPECT_EQ(a.after(b).inverse(), b.inverse().after(a.inverse()));
      for (const Symmetry c : all_symmetries()) EXPECT_EQ(a.after(b).after(c), a.after(b.after(c)));
    }
  }
}

TEST(Transformed, PreservesOrderAndArea) {
  Random random{21};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Polygon polygon = random_polygon(random, 1000);
    for (const Symmetry s : all_symmetries()) {
      const Polygon image = transformed(polygon, s);
      ASSERT_EQ(doubled_area(image), doubled_area(polygon));
      EXPECT_EQ(image.front(), s.apply(polygon.front()));
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t k = s.flips() ? (polygon.size() - i) % polygon.size() : i;
        ASSERT_EQ(image[k], s.apply(polygon[i]));
      }
      EXPECT_EQ(transformed(image, s.inverse()), polygon);
    }
  }
}

geometry::SplitOrientation split_of(bool flip, double rotation, double tilt) {
  return geometry::split({flip, Angle::of_degrees(rotation), Angle::of_degrees(tilt)});
}

TEST(Split, LeavesNoRotationForMultiplesOfNinety) {
  for (const bool flip : {false, true}) {
    for (int q = -9; q <= 9; ++q) {
      const geometry::SplitOrientation parts = split_of(flip, 90.0 * q, 0);
      EXPECT_EQ(parts.turn.degrees, 0);
      EXPECT_EQ(parts.symmetry, Symmetry(flip, q));
    }
  }
}

RC_GTEST_PROP(Split, RecombinesToTheOrientation, ()) {
  const bool flip = *rc::gen::arbitrary<bool>();
  const double rotation = *rc::gen::inRange(-7200, 7201) / 10.0;
  const double tilt = *rc::gen::inRange(-500, 501) / 100.0;
  const geometry::SplitOrientation parts = split_of(flip, rotation, tilt);
  RC_ASSERT(std::abs(parts.turn.degrees) <= 45.0 + 1e-9);
  RC_ASSERT(parts.symmetry.flips() == flip);
  const double turned_by = (flip ? -parts.turn.degrees : parts.turn.degrees) + 90.0 * parts.symmetry.quarter_turns();
  RC_ASSERT(std::abs(std::remainder(turned_by - rotation - tilt, 360.0)) < 1e-9);
}

// Applies flip, rotation and tilt in double precision.
RC_GTEST_PROP(Oriented, FlipsThenRotatesThenTilts, ()) {
  const bool flip = *rc::gen::arbitrary<bool>();
  const double rotation = *rc::gen::inRange(-360, 361);
  const double tilt = *rc::gen::inRange(-500, 501) / 100.0;
  Random random{*rc::gen::arbitrary<std::uint64_t>()};
  const Polygon polygon = random_star(random, 12, 1'000'000'000);
  const Polygon image = oriented(polygon, {flip, Angle::of_degrees(rotation), Angle::of_degrees(tilt)});
  RC_ASSERT(image.size() == polygon.size());  // so large that rounding does not make vertices collinear
  RC_ASSERT(doubled_area(image) > 0);
  const double radians = (rotation + tilt) * std::acos(-1.0) / 180.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto x = static_cast<double>(polygon[i].x);
    const auto y = static_cast<double>(flip ? -polygon[i].y : polygon[i].y);
    const Vec there = image[flip ? (polygon.size() - i) % polygon.size() : i];
    RC_ASSERT(std::abs(std::cos(radians) * x - std::sin(radians) * y - static_cast<double>(there.x)) < 0.51);
    RC_ASSERT(std::abs(std::sin(radians) * x + std::cos(radians) * y - static_cast<double>(there.y)) < 0.51);
  }
}

TEST(Oriented, IsExactForMultiplesOfNinety) {
  Random random{22};
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    const Polygon polygon = random_polygon(random, kLatticeLimit / 4);
    for (const Symmetry s : all_symmetries()) {
      const Orientation orientation{s.flips(), Angle::of_degrees(90.0 * s.quarter_turns() - 360), Angle{}};
      ASSERT_EQ(oriented(polygon, orientation), transformed(polygon, s));
    }
  }
}

TEST(Turned, RemovesVerticesThatRoundingMakesCollinear) {
  // The middle vertex of the flat side is one unit off the line; after a turn by 45 degrees and rounding it may lie on
  // it.
  const Polygon flat{{0, 0}, {1000, 1}, {2000, 0}, {2000, 900}, {0, 900}};
  Random random{23};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const Polygon image = turned(flat, Angle::of_degrees(random.part() * 45));
    const auto clean = clean_polygon(image);
    ASSERT_TRUE(clean);
    EXPECT_EQ(clean->repairs, geometry::Repairs{});
  }
}

}  // namespace
}  // namespace selvage::test
