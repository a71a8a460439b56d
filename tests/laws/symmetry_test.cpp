// Symmetry laws: motions on mirrored and scaled markers give mirrored and scaled results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/push.h"
#include "core/motion/piece/bump.h"
#include "tests/laws/random_marker.h"

namespace selvage::test {
namespace {

using test::kSlowdown;
using test::Random;

motion::piece::Bump bumped(const Marker& marker, std::uint32_t piece, double dx, double dy) {
  SumCache sums;
  return motion::piece::bump(scene::Scene{marker, sums}, PieceId{piece}, dx, dy);
}

// A random direction, sometimes along an axis.
double random_angle(Random& random) {
  return std::numbers::pi * (random.chance(30) ? static_cast<double>(random.below(4)) / 2 : 2 * random.part());
}

// The marker with some pieces turned by angles that need rounding; unchanged when there is no room for that.
Marker turned_a_little(Random& random, const Marker& marker) {
  Marker turned = marker;
  for (Piece& piece : turned.pieces) {
    if (random.chance(50)) piece.orientation.rotation.degrees += static_cast<double>(random.between(-30, 30)) / 10;
  }
  const auto made = make_marker(turned);
  return made && is_valid(*made) ? *made : marker;
}

// The results agree to the lattice unit.  The only exception would be a piece that moves exactly along the middle of
// the strip and can pass a corner on either side, which does not occur here.
TEST(SymmetryLaws, BumpingAMirroredMarkerGivesTheMirroredResult) {
  Random random{201};
  for (int trial = 0; trial < 6000 / kSlowdown; ++trial) {
    const Marker marker = turned_a_little(random, test::random_marker(random));
    const Marker reflection = test::mirrored(marker);
    ASSERT_TRUE(is_valid(reflection)) << trial;
    const auto piece = static_cast<std::uint32_t>(random.below(marker.pieces.size()));
    const double angle = random_angle(random);
    const motion::piece::Bump straight = bumped(marker, piece, std::cos(angle), std::sin(angle));
    const motion::piece::Bump reflected = bumped(reflection, piece, std::cos(angle), -std::sin(angle));
    ASSERT_EQ(straight.at.x, reflected.at.x) << trial;
    ASSERT_EQ(straight.at.y, marker.strip.width - reflected.at.y) << trial;
    ASSERT_EQ(straight.touching, reflected.touching) << trial;
  }
}

// A marker in mm and the same marker in tenths of a mm (every number is ten times as large).  The lattice is chosen
// from the numbers, so both have the same coordinates, and every motion gives identical bytes in units a tenth as long.
TEST(SymmetryLaws, TenTimesTheNumbersGiveTheSameCoordinates) {
  Random random{202};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const auto hundredths = random.between(1'000, 100'000'000);
    const double in_mm = static_cast<double>(hundredths) / 100;
    const double in_tenths = static_cast<double>(hundredths) / 10;
    const double extent = in_mm * static_cast<double>(random.between(1, 50));
    const Resolution coarse = geometry::choose_resolution(2, extent, in_mm);
    const Resolution fine = geometry::choose_resolution(1, 10 * extent, in_tenths);
    ASSERT_EQ(fine.exponent, coarse.exponent + 1) << trial;
    ASSERT_EQ(to_lattice(in_mm, coarse), to_lattice(in_tenths, fine)) << trial;
    const Coord coordinate = random.between(0, to_lattice(in_mm, coarse));
    ASSERT_NEAR(10 * to_decimal(coordinate, coarse), to_decimal(coordinate, fine), 1e-15 * to_decimal(coordinate, fine))
        << trial;
  }
}

TEST(SymmetryLaws, TheLengthOfTheUnitDoesNotMatter) {
  Random random{203};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const Marker marker = test::random_marker(random);
    Marker other = marker;
    other.resolution.exponent += 1;
    const auto settings = compaction_settings(motion::compaction::Accuracy::kStandard);
    SumCache sums;
    auto compacted = compact(marker, settings, {sums});
    auto same = compact(other, settings, {sums});
    ASSERT_TRUE(compacted && same) << trial;
    same->marker.resolution = marker.resolution;
    ASSERT_EQ(compacted->marker, same->marker) << trial;
    ASSERT_EQ(compacted->rounds, same->rounds) << trial;
  }
}

// On a lattice ten times as fine, the result is the same up to the rounding of the coarser lattice, unless rounding
// decides between two paths; the result is then another local optimum.
TEST(SymmetryLaws, AFinerLatticeGivesTheSameBumpUpToRounding) {
  Random random{204};
  const int trials = 1500 / kSlowdown;
  int same = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Marker marker = test::random_marker(random);
    const auto piece = static_cast<std::uint32_t>(random.below(marker.pieces.size()));
    const double angle = random_angle(random);
    const motion::piece::Bump coarse = bumped(marker, piece, std::cos(angle), std::sin(angle));
    const motion::piece::Bump fine = bumped(test::on_finer_lattice(marker), piece, std::cos(angle), std::sin(angle));
    const Vec off{10 * coarse.at.x - fine.at.x, 10 * coarse.at.y - fine.at.y};
    same += std::max(std::abs(off.x), std::abs(off.y)) <= 40 ? 1 : 0;
  }
  EXPECT_GE(same, trials * 85 / 100) << "of " << trials;
}

// Rectangles that move along the axes need no rounding.  On either lattice, however, a move of less than two units is
// not made.
TEST(SymmetryLaws, AFinerLatticeGivesRectanglesTheSameBump) {
  Random random{205};
  for (int trial = 0; trial < 1500 / kSlowdown; ++trial) {
    Marker marker = test::random_marker(random);
    for (Shape& shape : marker.shapes) {
      const Box box = box_of(shape.outline);
      shape.outline = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    }
    const auto piece = static_cast<std::uint32_t>(random.below(marker.pieces.size()));
    const auto towards = Symmetry{false, static_cast<int>(random.below(4))}.apply({1, 0});
    const auto dx = static_cast<double>(towards.x);
    const auto dy = static_cast<double>(towards.y);
    const motion::piece::Bump coarse = bumped(marker, piece, dx, dy);
    const motion::piece::Bump fine = bumped(test::on_finer_lattice(marker), piece, dx, dy);
    const Vec off{10 * coarse.at.x - fine.at.x, 10 * coarse.at.y - fine.at.y};
    ASSERT_LT(std::abs(off.x), 20) << trial;
    ASSERT_LT(std::abs(off.y), 20) << trial;
  }
}

}  // namespace
}  // namespace selvage::test
