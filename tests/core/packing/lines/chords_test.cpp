#include "core/packing/lines/chords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/real_plane.h"
#include "tests/support/polygons.h"

namespace selvage::packing::lines {
namespace {

// The chord of a polygon at a coordinate of no corner, by sorting its crossings.
double chord_at(const Polygon& polygon, Crossing crossing, double u) {
  std::vector<double> crossings;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    RealVec a = geometry::real(polygon[k]);
    RealVec b = geometry::real(polygon[(k + 1) % polygon.size()]);
    if (crossing == Crossing::kY) a = {a.y, a.x}, b = {b.y, b.x};
    if ((a.x < u) != (b.x < u)) crossings.push_back(a.y + (b.y - a.y) * ((u - a.x) / (b.x - a.x)));
  }
  std::sort(crossings.begin(), crossings.end());
  double sum = 0;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) sum += crossings[k + 1] - crossings[k];
  return sum;
}

using geometry::moved;

// Law: no chord is shorter than the least one of its part.
TEST(Chords, AreNeverShorterThanTheLeastOfTheirPart) {
  test::Random random{3};
  int some = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Coord extent = Coord{1} << random.between(8, 36);
    const Polygon polygon = clean_polygon(test::random_polygon(random, extent))->polygon;
    const Crossing crossing = random.below(2) == 0 ? Crossing::kX : Crossing::kY;
    const Box box = box_of(polygon);
    const Coord low = crossing == Crossing::kX ? box.low.x : box.low.y;
    const Coord high = crossing == Crossing::kX ? box.high.x : box.high.y;
    const double part = std::max(1.0, static_cast<double>(high - low) / static_cast<double>(random.between(1, 90)));
    const Chords chords = chords_of(std::vector<Polygon>{polygon}, crossing, part);
    for (int k = 0; k < 50; ++k) {
      const double u = static_cast<double>(random.between(low, high - 1)) + 0.5;
      const auto own = static_cast<std::size_t>((u - static_cast<double>(low)) / part);
      if (own >= chords.least.size()) continue;
      EXPECT_LE(chords.least[own], chord_at(polygon, crossing, u)) << "trial " << trial;
      EXPECT_LE(chords.least[own], chords.most);
      some += chords.least[own] > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(some, 1000);
}

TEST(Chords, OfAnL) {
  const Polygon l{{0, 0}, {40'000, 0}, {40'000, 10'000}, {20'000, 10'000}, {20'000, 30'000}, {0, 30'000}};
  const Chords chords = chords_of(std::vector<Polygon>{moved(l, {700, -9'000})}, Crossing::kX, 10'000);
  ASSERT_EQ(chords.least.size(), 4U);
  EXPECT_EQ(chords.least[0], 30'000 - kChordSlack);
  EXPECT_EQ(chords.least[1], 10'000 - kChordSlack);  // a unit behind it the polygon is lower
  EXPECT_EQ(chords.least[3], 10'000 - kChordSlack);
  EXPECT_EQ(chords.most, chords.least[0]);
}

TEST(Chords, OfPolygonsThatKeepTogetherCountOnceWhereTheyMayOverlap) {
  const Polygon square{{0, 0}, {10'000, 0}, {10'000, 10'000}, {0, 10'000}};
  const Chords chords = chords_of(std::vector<Polygon>{square, moved(square, {20'000, 0})}, Crossing::kX, 5'000);
  ASSERT_EQ(chords.least.size(), 6U);
  EXPECT_EQ(chords.least[1], 10'000 - kChordSlack);
  EXPECT_EQ(chords.least[2], 0);
  EXPECT_EQ(chords.least[5], 10'000 - kChordSlack);
}

TEST(FreeLengths, AreWhatPolygonsLeave) {
  const Polygon square{{0, 0}, {10'000, 0}, {10'000, 10'000}, {0, 10'000}};
  const std::vector<Polygon> polygons{moved(square, {0, -5'000}), moved(square, {5'000, 0}),
                                      moved(square, {5'000, 25'000})};
  const std::vector<double> at{2'000.5, 7'000.5, 12'000.5, 20'000.5};
  const auto free = free_lengths(at, 0, 30'000, polygons, Crossing::kX);
  const auto at_most = [](double length, double chords) { return length + kChordSlack + 2 * kCrossingError * chords; };
  EXPECT_EQ(free,
            (std::vector<double>{at_most(25'000, 1), at_most(15'000, 3), at_most(15'000, 2), at_most(30'000, 0)}));
}

// Law: pieces that do not overlap, wherever they lie, cover no more of a line than there is room.
TEST(Lines, HoldTheChordsOfPiecesSideBySide) {
  test::Random random{11};
  for (int trial = 0; trial < 50; ++trial) {
    constexpr Coord kSide = Coord{1} << 20;
    std::vector<std::vector<std::vector<Polygon>>> figures;
    std::vector<Polygon> obstacles;
    std::vector<Vec> lows;
    for (Coord column = 0; column < 3; ++column) {
      for (Coord row = 0; row < 3; ++row) {
        const Polygon polygon = clean_polygon(test::random_polygon(random, kSide / 2))->polygon;
        const Box box = box_of(polygon);
        const Vec at = Vec{column * kSide, row * kSide} - box.low;
        if (random.below(4) == 0) {
          obstacles.push_back(moved(polygon, at));
        } else {
          figures.push_back({{polygon}});
          lows.push_back({column * kSide, row * kSide});
        }
      }
    }
    const Box room{{0, 0}, {3 * kSide, 3 * kSide}};
    for (const Crossing crossing : {Crossing::kX, Crossing::kY}) {
      const Lines lines = lines_across(crossing, room, obstacles, figures);
      for (std::size_t line = 0; line < lines.at.size(); ++line) {
        double sum = 0;
        for (std::size_t k = 0; k < figures.size(); ++k) {
          const Coord low = crossing == Crossing::kX ? lows[k].x : lows[k].y;
          const double u = lines.at[line] - static_cast<double>(low);
          const auto part = static_cast<std::size_t>(std::max(0.0, u) / lines.part);
          if (u > 0 && part < lines.chords[k].front().least.size()) sum += lines.chords[k].front().least[part];
        }
        EXPECT_LE(sum, lines.room[line]);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::packing::lines
