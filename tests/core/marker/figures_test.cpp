// Tests of core/marker/figures.h: length, utilisation and validity, computed anew and after a change.
#include "core/marker/figures.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"
#include "tests/core/marker/squares.h"

namespace selvage::test {
namespace {

void expect_same(const marker::Figures& a, const marker::Figures& b) {
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.utilisation, b.utilisation);
  EXPECT_EQ(a.valid, b.valid);
}

TEST(Figures, EqualTheMarkersOwn) {
  const Marker marker = squares({{0, 0}, {10, 0}, {10, 90}});
  const marker::Figures figures = figures_of(marker);
  EXPECT_EQ(figures.length, length_of(marker));
  EXPECT_EQ(figures.utilisation, utilisation_of(marker));
  EXPECT_DOUBLE_EQ(figures.utilisation, 300.0 / (20 * 100));
  EXPECT_TRUE(figures.valid);
}

// Moves one piece to random positions; the figures after the change equal those computed from the whole marker.
TEST(Figures, AfterAMoveEqualThoseOfTheWholeMarker) {
  const Marker before = squares({{0, 0}, {10, 0}, {30, 30}});
  ASSERT_TRUE(is_valid(before));
  int valid = 0;
  for (Coord x = -5; x <= 45; x += 5) {
    for (Coord y = -5; y <= 95; y += 5) {
      Marker after = before;
      after.pieces[1].at = {x, y};
      const marker::Figures figures = figures_after(before, marker::PlacedPieces{before}, figures_of(before), after);
      expect_same(figures, figures_of(after));
      valid += figures.valid;
    }
  }
  EXPECT_GT(valid, 50);
  EXPECT_LT(valid, 11 * 21 - 20);
}

TEST(Figures, AreProvedAgainAfterAChangeOfStripOrSpacing) {
  const Marker before = squares({{0, 0}, {10, 0}, {30, 90}});
  Marker narrower = before;
  narrower.strip.width = 95;
  EXPECT_FALSE(figures_after(before, marker::PlacedPieces{before}, figures_of(before), narrower).valid);
  Marker spaced = before;
  spaced.spacing = 1;
  EXPECT_FALSE(figures_after(before, marker::PlacedPieces{before}, figures_of(before), spaced).valid);
  Marker other = before;
  other.shapes[0].outline = kTriangle;
  EXPECT_FALSE(figures_after(before, marker::PlacedPieces{before}, figures_of(before), other).valid);
  Marker more = squares({{0, 0}, {10, 0}, {30, 90}, {30, 85}});
  EXPECT_FALSE(figures_after(before, marker::PlacedPieces{before}, figures_of(before), more).valid);
}

TEST(Figures, AfterATiltUseTheTiltedOutline) {
  const Marker before = squares({{0, 0}, {10, 0}});
  Marker tilted = before;
  tilted.pieces[0].orientation.tilt = Angle::of_degrees(5);
  tilted.pieces[0].at = {1, 0};
  expect_same(figures_after(before, marker::PlacedPieces{before}, figures_of(before), tilted), figures_of(tilted));
  EXPECT_FALSE(figures_after(before, marker::PlacedPieces{before}, figures_of(before), tilted).valid);
}

}  // namespace
}  // namespace selvage::test
