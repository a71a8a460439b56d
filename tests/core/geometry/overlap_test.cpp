// Tests of overlap and common_point (core/geometry/overlap.h), on known cases and against CGAL.
#include "core/geometry/overlap.h"

#include <gtest/gtest.h>

#include "tests/support/exact.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

const Polygon kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

bool overlapping(const Polygon& p, const Polygon& q, Vec by = {}) {
  return overlap(placed(p), placed(q, by));
}

TEST(Overlap, IsFalseForTouchingPolygons) {
  EXPECT_FALSE(overlapping(kSquare, kSquare, {4, 0}));           // edge to edge
  EXPECT_FALSE(overlapping(kSquare, kSquare, {4, 3}));           // part of an edge
  EXPECT_FALSE(overlapping(kSquare, kSquare, {4, 4}));           // corner to corner
  EXPECT_FALSE(overlapping(kSquare, {{4, 2}, {6, 1}, {6, 3}}));  // a tip on an edge
  EXPECT_FALSE(overlapping({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}},
                           {{3, 3}, {6, 3}, {6, 8}, {3, 8}}));  // fills a slot from wall to wall
}

TEST(Overlap, IsTrueForOverlapsOfOneUnit) {
  EXPECT_TRUE(overlapping(kSquare, kSquare, {3, 3}));
  EXPECT_TRUE(overlapping(kSquare, {{3, 2}, {6, 1}, {6, 3}}));
}

TEST(Overlap, IsTrueWithoutProperCrossings) {
  EXPECT_TRUE(overlapping(kSquare, kSquare));                           // identical
  EXPECT_TRUE(overlapping(kSquare, {{1, 1}, {3, 1}, {2, 3}}));          // contained, away from the boundary
  EXPECT_TRUE(overlapping(kSquare, {{0, 0}, {4, 0}, {2, 3}}));          // contained, along an edge
  EXPECT_TRUE(overlapping(kSquare, {{2, 0}, {4, 2}, {2, 4}, {0, 2}}));  // contained, all corners on edges
  EXPECT_TRUE(overlapping(kSquare, {{0, 0}, {4, 4}, {0, 4}}));          // contained, corner to corner
  // A cross of two bars with ends on the lines of each other's edges: they cross only at vertices.
  EXPECT_TRUE(overlapping({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 3}, {0, 4}}, {{2, 2}, {4, 3}, {2, 4}}));
}

struct Answers {
  std::size_t overlapping{}, apart{};
};

void expect_exact_answer(const Polygon& p, const Polygon& q, Answers& counts) {
  const bool expected = interiors_meet(p, q);
  const std::string pair = text_of(p) + " and " + text_of(q);
  ASSERT_EQ(overlap(placed(p), placed(q)), expected) << pair;
  ASSERT_EQ(overlap(placed(q), placed(p)), expected) << pair;
  ++(expected ? counts.overlapping : counts.apart);
  const Vec here{-7, 3};
  const Polygon p_back = moved(p, -here);
  const Polygon q_forth = moved(q, here);
  ASSERT_EQ(overlap(placed(p_back, here), placed(q_forth, -here)), expected) << pair;
  const auto point = common_point(placed(p), placed(q));
  ASSERT_EQ(point.has_value(), expected) << pair;
  if (!point) return;
  ASSERT_EQ(locate_exactly({point->x, point->y}, p), geometry::Location::kInside)
      << pair << " at " << point->x << ", " << point->y;
  ASSERT_EQ(locate_exactly({point->x, point->y}, q), geometry::Location::kInside)
      << pair << " at " << point->x << ", " << point->y;
}

// The lattice is so small that vertices, edges and whole polygons coincide often.
TEST(Overlap, AgreesWithExactIntersectionOnSmallLattices) {
  Random random{41};
  std::vector<Polygon> pool;
  for (int k = 0; k < 400; ++k) {
    pool.push_back(random_simple(random, static_cast<std::size_t>(random.between(3, 8)), random.between(2, 8)));
  }
  Answers counts;
  for (int trial = 0; trial < 30'000 / kSlowdown; ++trial) {
    const Polygon p = pool[random.below(pool.size())];
    const Polygon q = trial % 50 == 0 ? p : transformed(pool[random.below(pool.size())], random.symmetry());
    // Positions at which the boxes at least touch.
    const Box a = box_of(p);
    const Box b = box_of(q);
    const Vec by{random.between(a.low.x - b.high.x, a.high.x - b.low.x),
                 random.between(a.low.y - b.high.y, a.high.y - b.low.y)};
    expect_exact_answer(p, trial % 100 == 0 ? q : moved(q, by), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.overlapping, 5000U / kSlowdown);
  EXPECT_GT(counts.apart, 5000U / kSlowdown);
}

TEST(Overlap, AgreesWithExactIntersectionOnDifficultShapes) {
  Random random{42};
  Answers counts;
  for (int trial = 0; trial < 1500 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 16);
    const Polygon q = transformed(random_polygon(random, 8), random.symmetry());
    expect_exact_answer(p, moved(q, random.point(-8, 24)), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.overlapping, 300U / kSlowdown);
  EXPECT_GT(counts.apart, 300U / kSlowdown);
}

// The same coincidences, or one unit off them, where a unit is 2^-37 of the polygon's size.
TEST(Overlap, IsExactOnLargeLattices) {
  Random random{43};
  Answers counts;
  for (int trial = 0; trial < 3000 / kSlowdown; ++trial) {
    const Coord factor = Coord{1} << random.between(30, 36);
    const Polygon p = scaled(random_simple(random, 6, 7), factor);
    Polygon q = scaled(moved(random_simple(random, 6, 7), random.point(-5, 5)), factor);
    q = moved(q, random.point(-1, 1));
    const bool expected = interiors_meet(p, q);
    ASSERT_EQ(overlap(placed(p), placed(q)), expected) << text_of(p) << " and " << text_of(q);
    ++(expected ? counts.overlapping : counts.apart);
  }
  EXPECT_GT(counts.overlapping, 500U / kSlowdown);
  EXPECT_GT(counts.apart, 500U / kSlowdown);
}

}  // namespace
}  // namespace selvage::test
