// Tests of closer_than and nearest_point (core/geometry/overlap.h), on known cases and against CGAL.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "core/geometry/overlap.h"
#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

TEST(CloserThan, IsFalseAtExactlyTheDistance) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_FALSE(closer_than(placed(square), placed(square, {9, 0}), 5));
  EXPECT_TRUE(closer_than(placed(square), placed(square, {9, 0}), 6));
  EXPECT_FALSE(closer_than(placed(square), placed(square, {7, 8}), 5));  // corner to corner: 3, 4, 5
  EXPECT_TRUE(closer_than(placed(square), placed(square, {7, 7}), 5));
  EXPECT_TRUE(closer_than(placed(square), placed(square, {4, 0}), 1));  // touching
  EXPECT_TRUE(closer_than(placed(square), placed(square, {1, 1}), 1));
  // A corner facing the middle of a slanted edge: (0,0) is 5 from the line 3x + 4y = 25.
  const Polygon slanted{{-1, 7}, {7, 1}, {7, 7}};
  const Polygon corner{{-4, -4}, {0, 0}, {-5, 0}};
  EXPECT_FALSE(closer_than(placed(slanted), placed(corner), 5));
  EXPECT_FALSE(closer_than(placed(corner), placed(slanted), 5));
  EXPECT_TRUE(closer_than(placed(slanted), placed(corner), 6));
}

struct Distances {
  std::size_t nearer{}, equal{}, farther{};
};

void expect_exact_answer(const Polygon& p, const Polygon& q, Coord distance, Distances& counts) {
  const bool ours = closer_than(placed(p), placed(q), distance);
  ASSERT_EQ(closer_than(placed(q), placed(p), distance), ours);
  if (interiors_meet(p, q)) {
    ASSERT_TRUE(ours) << text_of(p) << " and " << text_of(q);
    return;
  }
  const int sign = compare_distance(p, q, distance);
  ASSERT_EQ(ours, sign < 0) << text_of(p) << " and " << text_of(q) << " at " << distance;
  ++(sign < 0 ? counts.nearer : sign > 0 ? counts.farther : counts.equal);
}

TEST(CloserThan, AgreesWithExactDistancesOnSmallLattices) {
  Random random{51};
  Distances counts;
  for (int trial = 0; trial < 6000 / kSlowdown; ++trial) {
    const Polygon p = random_simple(random, static_cast<std::size_t>(random.between(3, 7)), 8);
    const Polygon q = random_simple(random, static_cast<std::size_t>(random.between(3, 7)), 8);
    expect_exact_answer(p, moved(q, random.point(-16, 16)), random.between(1, 8), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.nearer, 500U / kSlowdown);
  EXPECT_GT(counts.equal, 10U / kSlowdown);
  EXPECT_GT(counts.farther, 500U / kSlowdown);
}

TEST(CloserThan, IsExactOnLargeLattices) {
  Random random{52};
  Distances counts;
  for (int trial = 0; trial < 3000 / kSlowdown; ++trial) {
    const Coord factor = Coord{1} << random.between(28, 35);
    const Polygon p = scaled(random_simple(random, 5, 8), factor);
    const Polygon q = scaled(moved(random_simple(random, 5, 8), random.point(-12, 12)), factor);
    const Coord off = random.between(0, 1);  // exactly at the distance, or about a unit off
    expect_exact_answer(p, moved(q, random.point(-off, off)), random.between(1, 8) * factor + random.between(-off, off),
                        counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.nearer, 300U / kSlowdown);
  EXPECT_GT(counts.equal, 10U / kSlowdown);
  EXPECT_GT(counts.farther, 300U / kSlowdown);
}

// A corner next to the middle of a slanted edge whose distance from it is above or below the limit by a factor of about
// 1 + 2^-67, which doubles cannot resolve.
TEST(CloserThan, IsExactBeyondDoubles) {
  Random random{54};
  for (int trial = 0; trial < 200 / kSlowdown; ++trial) {
    const Coord m = random.between(Coord{1} << 30, Coord{1} << 34);
    const Coord distance = random.between(m / 4, m / 2);
    const Polygon edge{{0, 0}, {m / 2, -m}, {m, 1}};  // its long edge runs from (m, 1) to the origin
    // The corner and the edge form a triangle whose doubled area is the largest below distance * length.
    using Integer = boost::multiprecision::int512_t;
    const Integer below = boost::multiprecision::sqrt(Integer{Integer{distance} * distance * (Integer{m} * m + 1)});
    for (const int more : {0, 1}) {
      const Integer area = below + more;
      const auto y = static_cast<Coord>(Integer{(area + m - 1) / m});
      const Vec corner{static_cast<Coord>(Integer{Integer{m} * y - area}), y};
      const Polygon neighbour{corner, corner + Vec{5, 9}, corner + Vec{-5, 9}};
      ASSERT_EQ(closer_than(placed(edge), placed(neighbour), distance), more == 0);
      ASSERT_EQ(compare_distance(edge, neighbour, distance), more == 0 ? -1 : 1);
    }
  }
}

double distance_to(const Polygon& polygon, RealVec point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec a = polygon[i];
    const Vec d = polygon[(i + 1) % polygon.size()] - a;
    const auto dx = static_cast<double>(d.x);
    const auto dy = static_cast<double>(d.y);
    const double x = point.x - static_cast<double>(a.x);
    const double y = point.y - static_cast<double>(a.y);
    const double t = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(x - t * dx, y - t * dy));
  }
  return least;
}

TEST(NearestPoint, IsTheMidpointOfAShortestSegment) {
  Random random{53};
  std::size_t apart = 0;
  for (int trial = 0; trial < 2000 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 100);
    const Polygon q = moved(random_polygon(random, 100), random.point(-150, 150));
    if (overlap(placed(p), placed(q))) continue;
    ++apart;
    const RealVec middle = nearest_point(placed(p), placed(q));
    const double half = distance_to(p, middle);
    ASSERT_NEAR(half, distance_to(q, middle), 1e-9);
    // No pair of points is closer: the exact distance is twice that.
    ASSERT_GE(compare_distance(p, q, static_cast<Coord>(std::max(0.0, std::floor(2 * half - 1e-9)))), 0);
    ASSERT_LE(compare_distance(p, q, static_cast<Coord>(std::ceil(2 * half + 1e-9))), 0);
  }
  EXPECT_GT(apart, 500U / kSlowdown);
}

}  // namespace
}  // namespace selvage::test
