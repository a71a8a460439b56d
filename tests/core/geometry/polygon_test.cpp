// Tests of core/geometry/polygon.h: repair of vertex lists, point location and convexity.
#include "core/geometry/polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

ErrorCode error_of(const std::vector<Vec>& vertices) {
  const auto clean = clean_polygon(vertices);
  return clean ? ErrorCode{} : clean.error().code;
}

const Polygon kCleanSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(NormalForm, IsTheSameWhereverTheListStarts) {
  const Polygon polygon{{4, 0}, {6, 5}, {1, 7}, {1, 3}};
  Polygon rotated = polygon;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    EXPECT_EQ(geometry::normal_form(rotated), (Polygon{{1, 3}, {4, 0}, {6, 5}, {1, 7}}));
    EXPECT_EQ(geometry::normal_form(rotated, {-1, 2}), (Polygon{{0, 5}, {3, 2}, {5, 7}, {0, 9}}));
    std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
  }
}

TEST(CleanPolygon, LeavesACleanPolygonUnchanged) {
  const auto clean = clean_polygon(kCleanSquare);
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
  EXPECT_EQ(clean->repairs, geometry::Repairs{});
}

TEST(CleanPolygon, AcceptsARepeatedFirstVertexAtTheEnd) {
  const auto clean = clean_polygon(std::vector<Vec>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
  EXPECT_EQ(clean->repairs, geometry::Repairs{});
}

TEST(CleanPolygon, ReversesClockwisePolygons) {
  const auto clean = clean_polygon(std::vector<Vec>{{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
  EXPECT_EQ(clean->repairs, (geometry::Repairs{.reversed = true}));
}

TEST(CleanPolygon, RemovesRepeatedVertices) {
  const auto clean =
      clean_polygon(std::vector<Vec>{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}, {0, 0}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
  EXPECT_EQ(clean->repairs, (geometry::Repairs{.duplicate_vertices = 4}));
}

TEST(CleanPolygon, RemovesCollinearVertices) {
  const auto clean =
      clean_polygon(std::vector<Vec>{{2, 0}, {3, 0}, {4, 0}, {4, 1}, {4, 4}, {0, 4}, {0, 2}, {0, 0}, {1, 0}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, (Polygon{{4, 0}, {4, 4}, {0, 4}, {0, 0}}));
  EXPECT_EQ(clean->repairs, (geometry::Repairs{.collinear_vertices = 5}));
}

TEST(CleanPolygon, RemovesSpikes) {
  const auto clean = clean_polygon(std::vector<Vec>{{0, 0}, {4, 0}, {9, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 7}, {0, 3}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
  EXPECT_FALSE(clean->repairs.reversed);
}

TEST(CleanPolygon, RemovesNestedSpikes) {
  const auto clean = clean_polygon(std::vector<Vec>{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 9}, {8, 4}, {4, 4}, {0, 4}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon, kCleanSquare);
}

TEST(CleanPolygon, RemovesASpikeAtTheStartOfTheList) {
  const auto clean = clean_polygon(std::vector<Vec>{{-5, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}});
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->polygon.size(), 4U);
  EXPECT_EQ(doubled_area(clean->polygon), 32);
}

TEST(CleanPolygon, RejectsOutlinesWithoutArea) {
  EXPECT_EQ(error_of({}), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of({{1, 1}}), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of({{1, 1}, {2, 1}}), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of({{1, 1}, {2, 1}, {1, 1}}), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of({{1, 1}, {1, 1}, {1, 1}, {1, 1}}), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of({{0, 0}, {2, 1}, {4, 2}}), ErrorCode::kZeroArea);
  EXPECT_EQ(error_of({{0, 0}, {4, 2}, {2, 1}, {6, 3}}), ErrorCode::kZeroArea);
  EXPECT_EQ(error_of({{0, 0}, {4, 0}, {4, 4}, {4, 0}}), ErrorCode::kZeroArea);  // there and back again
}

TEST(CleanPolygon, RejectsOutlinesThatCrossOrTouchThemselves) {
  EXPECT_EQ(error_of({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), ErrorCode::kSelfIntersecting);  // bow tie
  EXPECT_EQ(error_of({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
            ErrorCode::kSelfIntersecting);  // vertex on an edge
  EXPECT_EQ(error_of({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}),
            ErrorCode::kSelfIntersecting);  // a vertex that occurs twice
  // Two edges that run along each other: a slot of width 0.
  EXPECT_EQ(error_of({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {0, 3}}),
            ErrorCode::kSelfIntersecting);
  EXPECT_EQ(error_of({{4, 0}, {6, 2}, {5, 0}, {8, 5}, {4, 3}, {8, 8}}),
            ErrorCode::kSelfIntersecting);  // two crossings
  const auto clean = clean_polygon(std::vector<Vec>{{0, 0}, {40, 40}, {40, 0}, {0, 39}});
  ASSERT_FALSE(clean);
  for (const char* corner : {"vertex 0", "vertex 1", "vertex 2", "vertex 3"}) {
    EXPECT_NE(clean.error().message.find(corner), std::string::npos) << clean.error().message;
  }
}

// A zigzag with `n` vertices, none of them redundant.
std::vector<Vec> saw(std::size_t n) {
  std::vector<Vec> vertices{{static_cast<Coord>(n), -9}, {0, -9}};
  while (vertices.size() < n) {
    const auto k = static_cast<Coord>(vertices.size());
    vertices.push_back({k, k % 2});
  }
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

TEST(CleanPolygon, RejectsMoreVerticesThanTheLimit) {
  EXPECT_EQ(error_of(saw(geometry::kMaxVertices + 1)), ErrorCode::kTooManyVertices);
  const auto clean = clean_polygon(saw(geometry::kMaxVertices));
  ASSERT_TRUE(clean) << clean.error().message;
  EXPECT_EQ(clean->polygon.size(), geometry::kMaxVertices);
  // Vertices are counted before repair, but without a repeated first vertex at the end.
  EXPECT_EQ(error_of(std::vector<Vec>(geometry::kMaxVertices + 1, Vec{1, 1})), ErrorCode::kTooFewVertices);
  EXPECT_EQ(error_of(std::vector<Vec>(geometry::kMaxVertices + 2, Vec{1, 1})), ErrorCode::kTooManyVertices);
}

// Every accepted outline becomes a Polygon, and every outline rejected as self-intersecting is not simple.
TEST(CleanPolygon, AgreesWithExactSimplicity) {
  Random random{11};
  std::size_t simple = 0;
  std::size_t refused = 0;
  for (int trial = 0; trial < 20'000 / kSlowdown; ++trial) {
    std::vector<Vec> vertices(static_cast<std::size_t>(random.between(3, 9)));
    for (Vec& v : vertices) v = random.point(0, 7);
    const auto clean = clean_polygon(vertices);
    if (clean) {
      ++simple;
      const Polygon& p = clean->polygon;
      ASSERT_TRUE(is_simple_exactly(p)) << text_of(vertices);
      ASSERT_GT(doubled_area(p), 0) << text_of(vertices);
      for (std::size_t i = 0; i < p.size(); ++i) {
        ASSERT_NE(side_of(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]), 0) << text_of(vertices);
      }
      ASSERT_EQ(vertices.size(), p.size() + clean->repairs.duplicate_vertices + clean->repairs.collinear_vertices +
                                     (vertices.front() == vertices.back() ? 1U : 0U))
          << text_of(vertices);
    } else if (clean.error().code == ErrorCode::kSelfIntersecting) {
      ++refused;
      ASSERT_FALSE(is_simple_exactly(vertices)) << text_of(vertices);
    }
  }
  EXPECT_GT(simple, 1000U / kSlowdown);
  EXPECT_GT(refused, 1000U / kSlowdown);
}

TEST(CleanPolygon, RepairsDefectsAddedToAPolygon) {
  Random random{12};
  for (int trial = 0; trial < 2000 / kSlowdown; ++trial) {
    const Polygon polygon = scaled(random_polygon(random, 20), 4);
    std::vector<Vec> damaged;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec a = polygon[i];
      const Vec b = polygon[(i + 1) % polygon.size()];
      damaged.push_back(a);
      if (random.chance(30)) damaged.push_back(a);
      if (random.chance(30)) damaged.push_back({a.x + (b.x - a.x) / 4, a.y + (b.y - a.y) / 4});
      if (random.chance(30)) damaged.push_back({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
    }
    const bool reversed = random.chance(50);
    if (reversed) std::reverse(damaged.begin(), damaged.end());
    const auto clean = clean_polygon(damaged);
    ASSERT_TRUE(clean) << text_of(damaged);
    EXPECT_EQ(clean->repairs.reversed, reversed);
    Polygon again = clean->polygon;
    const auto first = std::find(again.begin(), again.end(), polygon.front());
    ASSERT_NE(first, again.end());
    std::rotate(again.begin(), first, again.end());
    ASSERT_EQ(again, polygon) << text_of(damaged);
  }
}

TEST(Locate, AgreesWithExactLocation) {
  Random random{13};
  std::size_t counts[3]{};
  for (int trial = 0; trial < 400 / kSlowdown; ++trial) {
    const Polygon polygon = random_polygon(random, random.chance(50) ? 8 : 30);
    for (int k = 0; k < 40; ++k) {
      const Vec p = random.point(-1, 31);
      const geometry::Location ours = locate(p, polygon);
      const RealVec at{static_cast<double>(p.x), static_cast<double>(p.y)};
      ASSERT_EQ(ours, locate_exactly(at, polygon)) << text_of({p}) << " in " << text_of(polygon);
      ++counts[static_cast<int>(ours)];
    }
  }
  for (const std::size_t count : counts) EXPECT_GT(count, 500U / kSlowdown);
}

TEST(Locate, IsExactOnLargeLattices) {
  // Points one unit off the long diagonal of a triangle as large as the lattice.
  const Coord far = kLatticeLimit - 1;
  const Polygon triangle{{-far, -far}, {far, far - 1}, {-far, far}};
  EXPECT_EQ(locate({-far, -far}, triangle), geometry::Location::kBoundary);
  EXPECT_EQ(locate({0, 0}, triangle), geometry::Location::kInside);
  EXPECT_EQ(locate({0, -1}, triangle), geometry::Location::kOutside);
  EXPECT_EQ(locate({far - 1, far - 2}, triangle), geometry::Location::kOutside);
  EXPECT_EQ(locate({far - 1, far - 1}, triangle), geometry::Location::kInside);
}

TEST(Convexity, HoldsForRandomConvexPolygonsOnly) {
  Random random{14};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    EXPECT_TRUE(is_convex(random_convex(random, 12, 1'000'000)));
    const Polygon comb = random_comb(random, 3, 50, trial % 2 == 0);
    EXPECT_FALSE(is_convex(comb)) << text_of(comb);
  }
  EXPECT_FALSE(is_convex(Polygon{{0, 0}, {0, 4}, {4, 4}, {4, 0}}));
}

}  // namespace
}  // namespace selvage::test
