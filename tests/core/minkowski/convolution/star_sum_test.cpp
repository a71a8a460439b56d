// Tests of the sums of two star-shaped or convex polygons, and of properties that follow from the definition of a
// Minkowski sum.
#include "core/minkowski/convolution/star_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "core/minkowski/convolution/convex_sum.h"
#include "core/minkowski/sum.h"
#include "tests/core/minkowski/sum_laws.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

outline::StarPart part_of(const Polygon& polygon) {
  auto parts = outline::star_parts(polygon);
  EXPECT_EQ(parts.size(), 1U);
  return parts.front();
}

std::optional<minkowski::convolution::StarSum> star_sum_of(const Polygon& p, const Polygon& q,
                                                           const std::function<bool()>& stopped) {
  const outline::StarPart first = part_of(p);
  const outline::StarPart second = part_of(q);
  const minkowski::convolution::Turns of_first{first.vertices};
  const minkowski::convolution::Turns of_second{second.vertices};
  return minkowski::convolution::star_sum({first, of_first}, {second, of_second}, stopped);
}

minkowski::convolution::StarSum star_sum_of(const Polygon& p, const Polygon& q) {
  return *star_sum_of(p, q, {});
}

minkowski::MinkowskiSum sum_of(const Polygon& p, const Polygon& q) {
  return minkowski::minkowski_sum(outline::star_parts(p), outline::star_parts(q));
}

// The exact lines of the edges, sorted.
std::vector<std::pair<Vec, Vec>> lines_of(std::span<const minkowski::convolution::SumEdge> edges) {
  std::vector<std::pair<Vec, Vec>> lines;
  for (const minkowski::convolution::SumEdge& e : edges) lines.emplace_back(e.line_from, e.line_to);
  std::sort(lines.begin(), lines.end());
  return lines;
}

Polygon corners_of(const minkowski::convolution::StarSum& sum) {
  Polygon corners;
  for (const minkowski::convolution::SumEdge& e : sum.edges) corners.push_back(e.from);
  return clean_polygon(corners)->polygon;
}

TEST(StarSum, HasKnownEdgesForASquareAndATriangle) {
  const minkowski::convolution::StarSum sum =
      star_sum_of({{0, 0}, {40, 0}, {40, 40}, {0, 40}}, {{0, 0}, {30, 0}, {0, 30}});
  Polygon corners = corners_of(sum);
  std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), Vec{0, 0}), corners.end());
  EXPECT_EQ(corners, (Polygon{{0, 0}, {70, 0}, {70, 40}, {40, 70}, {0, 70}}));
}

TEST(StarSum, RecordsTheSourceOfEachEdge) {
  // A square and a small triangle below it to the left: the upper edge of the sum is the square's edge plus the
  // triangle's highest vertex.
  const minkowski::convolution::StarSum sum =
      star_sum_of({{0, 0}, {40, 0}, {40, 40}, {0, 40}}, {{-8, -9}, {-2, -8}, {-5, -3}});
  const auto top = std::find_if(sum.edges.begin(), sum.edges.end(), [](const minkowski::convolution::SumEdge& e) {
    return e.line_from == Vec{35, 37};
  });
  ASSERT_NE(top, sum.edges.end());
  EXPECT_EQ(top->line_to, (Vec{-5, 37}));
  EXPECT_EQ(top->source, (minkowski::convolution::EdgeSource{.vertex = 2, .edge = 2, .vertex_of_first = false}));
}

TEST(StarSum, MayBeStoppedAgainAndAgain) {
  Random random{129};
  constexpr std::size_t kVertices = 200;
  const Polygon p = random_star(random, kVertices, 1'000'000);
  const Polygon q = random_star(random, kVertices, 1'000'000);
  std::size_t asked = 0;
  ASSERT_TRUE(star_sum_of(p, q, [&asked] {
    ++asked;
    return false;
  }));
  EXPECT_GE(asked, (p.size() + q.size()) / 32 + 3);  // three passes merge up to eight chains
  for (std::size_t last = 1; last <= asked; ++last) {
    std::size_t calls = 0;
    ASSERT_FALSE(star_sum_of(p, q, [&] { return ++calls == last; })) << last;
    ASSERT_EQ(calls, last);
  }
}

// Regression: two candidates that cross exactly on the ray where angles pass half a turn; one was taken to last for the
// whole turn.
TEST(StarSum, KeepsAnEdgeThatStartsOnTheAxis) {
  const Polygon p{{13, 13}, {8, 16}, {3, 13}, {12, 10}, {8, 8}, {8, 6}, {9, 5}, {8, 3}, {14, 10}, {15, 10}, {13, 12}};
  const Summands summands{scaled(p, 123'457), scaled({{1, 2}, {2, 0}, {5, 0}, {2, 2}}, 123'457), {}};
  EXPECT_EQ(broken_source(summands, sum_of(summands.first, summands.second)), "");
}

TEST(StarSum, EqualsConvexSumForConvexPolygons) {
  Random random{121};
  for (int trial = 0; trial < 2000 / kSlowdown; ++trial) {
    const Coord extent = random.chance(30) ? 24 : random.chance(50) ? 1'000'000 : kLatticeLimit / 2;
    const Polygon p = random_convex(random, static_cast<std::size_t>(random.between(3, 12)), extent);
    const Polygon q = random_convex(random, static_cast<std::size_t>(random.between(3, 12)), extent);
    const minkowski::convolution::StarSum merge = minkowski::convolution::convex_sum(part_of(p), part_of(q));
    const minkowski::convolution::StarSum star = star_sum_of(p, q);
    Polygon a = corners_of(merge);
    Polygon b = corners_of(star);
    std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
    std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
    ASSERT_EQ(a, b) << text_of(p) << "; " << text_of(q);
    ASSERT_EQ(broken_source({p, q, {}}, minkowski::MinkowskiSum{{merge}}), "");
    // The area of the sum of two convex polygons is at least the sum of their areas.
    ASSERT_GE(doubled_area(a), doubled_area(p) + doubled_area(q));
  }
}

TEST(Sum, IsCommutative) {
  Random random{122};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const Polygon p = random_star(random, 20, 1'000'000);
    const Polygon q = random_star(random, 20, 1'000'000);
    const minkowski::MinkowskiSum forth = sum_of(p, q);
    const minkowski::MinkowskiSum back = sum_of(q, p);
    EXPECT_EQ(forth.box(), back.box());
    ASSERT_TRUE(forth.rings().size() > 1 || lines_of(forth.edges()) == lines_of(back.edges()));
  }
}

TEST(Sum, IsTranslatedWithItsSummands) {
  Random random{123};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 1'000'000);
    const Polygon q = random_polygon(random, 1'000'000);
    const Vec by = random.point(-1'000'000'000, 1'000'000'000);
    auto here = lines_of(sum_of(p, q).edges());
    for (auto& [from, to] : here) {
      from = from + by;
      to = to + by;
    }
    const auto there = sum_of(moved(p, by), q);
    ASSERT_EQ(lines_of(there.edges()), here) << text_of(p) << "; " << text_of(q);
  }
}

TEST(Sum, IsTransformedWithItsSummands) {
  Random random{124};
  for (int trial = 0; trial < 300 / kSlowdown; ++trial) {
    const Polygon p = random_star(random, 15, 1'000'000);
    const Polygon q = random_star(random, 15, 1'000'000);
    const Symmetry s = random.symmetry();
    const minkowski::MinkowskiSum plain = sum_of(p, q);
    const minkowski::MinkowskiSum image = sum_of(transformed(p, s), transformed(q, s));
    if (plain.rings().size() != 1 || image.rings().size() != 1) continue;
    std::vector<std::pair<Vec, Vec>> expected;
    for (const auto& [from, to] : lines_of(plain.edges())) {
      expected.emplace_back(s.apply(s.flips() ? to : from), s.apply(s.flips() ? from : to));
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(lines_of(image.edges()), expected) << text_of(p) << "; " << text_of(q);
  }
}

TEST(Sum, OfAPolygonAndItsReflectionContainsTheOrigin) {
  Random random{125};
  for (int trial = 0; trial < 500 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 100'000);
    const auto outline = outline::make_outline(p);
    EXPECT_TRUE(minkowski::obstacle_sum(*outline, *outline, {}).contains({0, 0})) << text_of(p);
  }
}

// Complete small cases with holes, slots and closed rings.
// Two saws of n equal teeth have n * n sums of teeth, of which 2 n - 1 differ.
TEST(Sum, HasEachRingOnce) {
  const auto saw_outline = outline::make_outline(saw(40, 1000, 5000));
  const std::size_t parts = saw_outline->parts.size();
  const auto sum = minkowski::obstacle_sum(*saw_outline, *saw_outline, {});
  EXPECT_GT(parts * parts, 1000U);
  EXPECT_LT(sum.rings().size(), 8 * parts);
}

TEST(Sum, IsNothingWhenCancelled) {
  const auto comb = outline::make_outline(saw(40, 1000, 5000));
  EXPECT_TRUE(minkowski::obstacle_sum(*comb, *comb, {}, [] { return false; }));
  for (const std::size_t most : {std::size_t{5}, comb->parts.size() * comb->parts.size() + 5}) {  // parts; rings
    std::size_t asked = 0;
    EXPECT_FALSE(minkowski::obstacle_sum(*comb, *comb, {}, [&] { return ++asked == most; }));
    EXPECT_EQ(asked, most);
  }
}

TEST(Sum, HasAHoleWhereAPieceFitsLoosely) {
  const Polygon ring = scaled(broken_ring(30, 5, 2), 100);
  const Polygon square = scaled({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, 100);
  const auto sum = minkowski::obstacle_sum(*outline::make_outline(ring), *outline::make_outline(square), {});
  EXPECT_FALSE(sum.contains({1000, 1000}));  // inside the ring
  EXPECT_TRUE(sum.contains({300, 1000}));
  const Summands summands{ring, square, Symmetry{false, 2}};
  EXPECT_EQ((ExactSum{ring, summands.second_image(), ExactSum::Method::kDecomposition}.holes()), 1U);
  EXPECT_EQ(broken_law(summands, sum), "");
}

TEST(Sum, KeepsASlotThatAPieceFillsExactly) {
  // A square as wide as the gap between the arms of a U: its positions there form a line of zero width.
  const Polygon u = scaled({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}}, 100);
  const Polygon square = scaled({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 100);
  const auto sum = minkowski::obstacle_sum(*outline::make_outline(u), *outline::make_outline(square), {});
  Coord up = 0;
  Coord down = 0;
  for (const minkowski::convolution::SumEdge& e : sum.edges()) {
    if (e.from.x != 300 || e.to.x != 300) continue;
    (e.to.y > e.from.y ? up : down) += std::abs(e.to.y - e.from.y);
  }
  EXPECT_NEAR(static_cast<double>(up), 600, 2);
  EXPECT_NEAR(static_cast<double>(down), 600, 2);
  EXPECT_EQ(broken_law({u, square, Symmetry{false, 2}}, sum), "");
}

}  // namespace
}  // namespace selvage::test
