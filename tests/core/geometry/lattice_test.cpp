// Tests of core/geometry/lattice.h: conversion between decimals and lattice coordinates, boxes and exact products.
#include "core/geometry/lattice.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cstdlib>
#include <string>

namespace selvage::test {
namespace {

rc::Gen<Coord> coords() {
  return rc::gen::inRange<Coord>(-kLatticeLimit + 1, kLatticeLimit);
}
rc::Gen<Resolution> resolutions() {
  return rc::gen::map(rc::gen::inRange(geometry::kFinestExponent, geometry::kCoarsestExponent + 1),
                      [](int e) { return Resolution{e}; });
}

// The decimal text of coord * 10^exponent, built from its digits only.
std::string decimal_text(Coord coord, int exponent) {
  return std::to_string(coord) + "e" + std::to_string(exponent);
}

std::string shortest_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

TEST(Segments, MeetWhereTheyShareAPoint) {
  const auto meet = [](Vec a, Vec b, Vec c, Vec d) {
    const bool met = geometry::segments_meet(a, b, c, d);
    EXPECT_EQ(geometry::segments_meet(b, a, c, d), met);
    EXPECT_EQ(geometry::segments_meet(c, d, a, b), met);
    return met;
  };
  EXPECT_TRUE(meet({0, 0}, {4, 4}, {0, 4}, {4, 0}));     // they cross
  EXPECT_TRUE(meet({0, 0}, {4, 4}, {4, 4}, {9, 0}));     // they share an end
  EXPECT_TRUE(meet({0, 0}, {4, 0}, {2, 0}, {2, 7}));     // an end lies inside the other
  EXPECT_TRUE(meet({0, 0}, {4, 2}, {2, 1}, {8, 4}));     // they overlap on a line
  EXPECT_TRUE(meet({3, 3}, {3, 3}, {0, 0}, {4, 4}));     // a point on a segment
  EXPECT_FALSE(meet({0, 0}, {4, 2}, {6, 3}, {8, 4}));    // apart on a line
  EXPECT_FALSE(meet({0, 0}, {4, 0}, {0, 1}, {4, 1}));    // parallel
  EXPECT_FALSE(meet({0, 0}, {4, 4}, {3, 2}, {4, 0}));    // would meet if longer
  EXPECT_FALSE(meet({0, 0}, {9, 0}, {10, 5}, {10, 0}));  // on the other's line, beyond its end
}

TEST(Decimals, AreCountedInTheShortestText) {
  EXPECT_EQ(geometry::decimals_of(0), 0);
  EXPECT_EQ(geometry::decimals_of(100), 0);
  EXPECT_EQ(geometry::decimals_of(12.5), 1);
  EXPECT_EQ(geometry::decimals_of(-12.5), 1);
  EXPECT_EQ(geometry::decimals_of(0.1), 1);
  EXPECT_EQ(geometry::decimals_of(0.30000000000000004), 17);
  EXPECT_EQ(geometry::decimals_of(1e-7), 7);
  EXPECT_EQ(geometry::decimals_of(1.25e-7), 9);
  EXPECT_EQ(geometry::decimals_of(1e22), 0);
  EXPECT_EQ(geometry::decimals_of(1.5e300), 0);
  EXPECT_EQ(geometry::decimals_of(5e-324), 324);
}

RC_GTEST_PROP(Decimals, EqualTheNumberWritten, ()) {
  const Coord whole = *rc::gen::inRange<Coord>(1, 1'000'000);
  const int decimals = *rc::gen::inRange(1, 9);
  RC_PRE(whole % 10 != 0);
  const double value = std::strtod(decimal_text(whole, -decimals).c_str(), nullptr);
  RC_ASSERT(geometry::decimals_of(value) == decimals);
}

RC_GTEST_PROP(Lattice, CoordinatesRoundTripThroughText, ()) {
  const Coord coord = *coords();
  const Resolution resolution = *resolutions();
  const double decimal = to_decimal(coord, resolution);
  RC_ASSERT(fits_lattice(decimal, resolution));
  RC_ASSERT(to_lattice(decimal, resolution) == coord);
  const double read_back = std::strtod(shortest_text(decimal).c_str(), nullptr);
  RC_ASSERT(to_lattice(read_back, resolution) == coord);
}

RC_GTEST_PROP(Lattice, DecimalTextIsExact, ()) {
  const Coord coord = *coords();
  const Resolution resolution = *resolutions();
  const double written = std::strtod(decimal_text(coord, resolution.exponent).c_str(), nullptr);
  RC_ASSERT(to_lattice(written, resolution) == coord);
  RC_ASSERT(to_decimal(coord, resolution) == written);
  // The shortest text has no more decimals than the lattice.
  RC_ASSERT(geometry::decimals_of(to_decimal(coord, resolution)) <= std::max(0, -resolution.exponent));
}

TEST(Lattice, RoundsToTheNearestUnit) {
  EXPECT_EQ(to_lattice(1.24, Resolution{-1}), 12);
  EXPECT_EQ(to_lattice(1.26, Resolution{-1}), 13);
  EXPECT_EQ(to_lattice(-1.26, Resolution{-1}), -13);
  EXPECT_EQ(to_lattice(1'499'999, Resolution{6}), 1);
  EXPECT_EQ(to_lattice(-1'500'001, Resolution{6}), -2);
}

TEST(Lattice, RejectsValuesFromItsLimitOn) {
  const auto limit = static_cast<double>(kLatticeLimit);
  EXPECT_FALSE(fits_lattice(limit, Resolution{0}));
  EXPECT_FALSE(fits_lattice(-limit, Resolution{0}));
  EXPECT_TRUE(fits_lattice(limit - 1, Resolution{0}));
  EXPECT_FALSE(fits_lattice(limit, Resolution{-1}));
  EXPECT_FALSE(fits_lattice(std::numeric_limits<double>::infinity(), Resolution{6}));
  EXPECT_FALSE(fits_lattice(std::numeric_limits<double>::quiet_NaN(), Resolution{6}));
}

RC_GTEST_PROP(ChosenResolution, KeepsDecimalsWhereTheLatticeAllows, ()) {
  const int decimals = *rc::gen::inRange(0, 25);
  const double extent = *rc::gen::map(rc::gen::inRange(0, 12'000), [](int k) { return std::pow(10.0, k / 1000.0); });
  const double width = extent / *rc::gen::inRange(1, 1000);
  const Resolution chosen = geometry::choose_resolution(decimals, extent, width);
  RC_ASSERT(fits_lattice(extent, chosen));
  const Resolution finer{chosen.exponent - 1};
  const bool roomy = fits_lattice(geometry::kHeadroom * extent, chosen);
  const bool exact = chosen.exponent <= -decimals;
  const bool fine = width / std::pow(10.0, chosen.exponent) >= (1 << 28);
  // It is coarser than the decimals only if the lattice cannot be exact, and then it has headroom.
  if (!exact) {
    RC_ASSERT(!fits_lattice(extent, Resolution{-decimals}) || -decimals < geometry::kFinestExponent);
    RC_ASSERT(roomy);
  }
  // It has less headroom only if it is just exact, and is coarser than 2^28 units across only for headroom.
  if (!roomy) RC_ASSERT(chosen.exponent == -decimals);
  if (!exact || !fine) {
    RC_ASSERT(chosen.exponent == geometry::kFinestExponent || !fits_lattice(geometry::kHeadroom * extent, finer));
  }
}

TEST(ChosenResolution, HasKnownValuesForTypicalMarkers) {
  EXPECT_EQ(geometry::choose_resolution(3, 9000, 1500), (Resolution{-6}));  // 1.5e9 units wide
  EXPECT_EQ(geometry::choose_resolution(14, 100, 60), (Resolution{-9}));    // as fine as headroom allows
  EXPECT_EQ(geometry::choose_resolution(9, 990, 1000), (Resolution{-9}));   // exact, with little headroom
  EXPECT_EQ(geometry::choose_resolution(0, 1e15, 1e15), (Resolution{4}));
  EXPECT_EQ(geometry::choose_resolution(8, 10, 0), (Resolution{-8}));  // without a strip only the decimals count
}

TEST(Boxes, OverlapOnlyIfTheirInteriorsIntersect) {
  const Box box{{0, 0}, {4, 3}};
  EXPECT_TRUE(box.touches(box.moved({4, 3})));
  EXPECT_FALSE(box.overlaps(box.moved({4, 0})));
  EXPECT_TRUE(box.overlaps(box.moved({3, 2})));
  EXPECT_FALSE(box.touches(box.moved({0, 4})));
  EXPECT_TRUE(box.grown(1).touches(box.moved({0, 4})));
  const std::vector<Vec> points{{2, 7}, {-1, 3}, {5, 4}};
  EXPECT_EQ(box_of(points), (Box{{-1, 3}, {5, 7}}));
}

RC_GTEST_PROP(Products, AreExactAcrossTheLattice, ()) {
  // Identities of cross, dot and side_of that only exact arithmetic satisfies.
  const Vec a{*coords(), *coords()};
  const Vec b{*coords(), *coords()};
  RC_ASSERT(cross(a, b) == -cross(b, a));
  RC_ASSERT(cross(a, a + b) == cross(a, b));
  RC_ASSERT(dot(a, b) == cross(a, Vec{-b.y, b.x}));
  RC_ASSERT(side_of(a, b, a) == 0);
}

}  // namespace
}  // namespace selvage::test
