#include "core/packing/cells/wedge_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/minkowski/nearest_edges.h"
#include "core/outline/outline.h"
#include "core/packing/cells/hull.h"
#include "tests/support/polygons.h"

namespace selvage::packing::cells {
namespace {

// The rings of two random pieces, as computed by the search.
std::vector<WedgeRing> rings_of(const minkowski::Obstacle& obstacle, Vec offset) {
  std::vector<WedgeRing> rings;
  for (const auto& sum : obstacle.sum().rings()) rings.emplace_back(sum, obstacle, offset);
  return rings;
}

bool in_some_cell(const WedgeRing& ring, Vec at) {
  const RealVec p = geometry::real(at);
  const RealBox box{p.x - 1, p.y - 1, p.x + 1, p.y + 1};
  Cell cell;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    if (ring.clip(k, box, cell)) return true;
  }
  return false;
}

// (1) Positions outside a sum are in a cell of each of its rings.  (2) Positions well inside the sum are in no cell of
// some ring.
TEST(WedgeRing, CellsCoverExactlyTheOutside) {
  test::Random random{5};
  int inside = 0;
  int outside = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Coord extent = Coord{1} << random.between(12, 34);
    SumCache sums;
    const auto p = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
    const auto q = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
    const auto obstacle = sums.obstacle({p, random.symmetry()}, {q, random.symmetry()});
    const Vec offset = random.point(-extent, extent);
    const auto rings = rings_of(obstacle, offset);
    for (int point = 0; point < 200; ++point) {
      const Vec at = random.point(-2 * extent, 2 * extent);
      const auto nearest = nearest_boundary_point(obstacle.sum(), obstacle.to_frame(at));
      const bool is_inside = obstacle.sum().contains(geometry::real(obstacle.to_frame(at)));
      const bool in_all = std::all_of(rings.begin(), rings.end(),
                                      [&](const WedgeRing& ring) { return in_some_cell(ring, at + offset); });
      if (!is_inside) {
        EXPECT_TRUE(in_all) << "trial " << trial << ", " << at.x << " " << at.y;
      }
      if (is_inside && nearest.distance > 64) {
        EXPECT_FALSE(in_all) << "trial " << trial;
      }
      ++(is_inside ? inside : outside);
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

// The first ring of two random polygons' sum.
WedgeRing random_ring(test::Random& random, Coord extent) {
  SumCache sums;
  const auto p = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
  const auto q = sums.outline(clean_polygon(test::random_polygon(random, extent))->polygon);
  return rings_of(sums.obstacle({p, random.symmetry()}, {q, random.symmetry()}), {}).front();
}

// The count of an arc's wedge from its first one; at least `size` where the arc does not have it.
std::uint32_t count_in(Arc arc, std::uint32_t wedge, std::uint32_t size) {
  const std::uint32_t count = (wedge + size - arc.first) % size;
  return count < arc.count ? count : size;
}

// (1) Every wedge of an arc that a position in the box lies in is in the part of the arc that faces the box.  (2) That
// part is seldom the whole arc.
TEST(WedgeRing, HasNoPositionsInABoxBesideThePartThatFacesIt) {
  test::Random random{6};
  int narrowed = 0;
  int found = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Coord extent = Coord{1} << random.between(12, 34);
    const WedgeRing ring = random_ring(random, extent);
    const RealVec a = geometry::real(random.point(-2 * extent, 2 * extent));
    const RealVec b = geometry::real(random.point(-extent / 4, extent / 4));
    const RealBox box{a.x - std::abs(b.x), a.y - std::abs(b.y), a.x + std::abs(b.x), a.y + std::abs(b.y)};
    const Arc arc = trial % 3 == 0 ? ring.whole()
                                   : Arc{static_cast<std::uint32_t>(random.below(ring.size())),
                                         static_cast<std::uint32_t>(1 + random.below(ring.size() - 1))};
    const auto [begin, end] = ring.part_facing(arc, box);
    narrowed += end - begin < arc.count ? 1 : 0;
    for (int step = 0; step <= 400; ++step) {
      const RealVec at{box.low_x + box.width() * (step % 21) / 20, box.low_y + box.height() * (step / 21) / 20};
      const std::uint32_t count = count_in(arc, ring.facing(at), ring.size());
      if (count == ring.size()) continue;
      ++found;
      const bool in_part = (begin <= count && count < end) || count + ring.size() < end;
      EXPECT_TRUE(in_part) << "trial " << trial << ", step " << step;
    }
  }
  EXPECT_GT(narrowed, 200);
  EXPECT_GT(found, 10'000);
}

// The position of a box at parts of its width and height.
RealVec at_parts(const RealBox& box, double x, double y) {
  return {box.low_x + x * box.width(), box.low_y + y * box.height()};
}

// Every position of a box that is in a wedge is in the part of the box that the wedge is said to lie within.
TEST(WedgeRing, LiesWithinWhatItIsSaidTo) {
  test::Random random{7};
  int within = 0;
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Coord extent = Coord{1} << random.between(12, 34);
    const WedgeRing ring = random_ring(random, extent);
    const RealVec a = geometry::real(random.point(-2 * extent, 2 * extent));
    const RealVec b = geometry::real(random.point(extent / 8, extent));
    const RealBox box{a.x - b.x, a.y - b.y, a.x + b.x, a.y + b.y};
    RealBox part = box;
    const double inset = static_cast<double>(random.below(100)) / 100;
    (trial % 2 == 0 ? part.low_x : part.high_x) = at_parts(box, trial % 2 == 0 ? inset : 1 - inset, 0).x;
    if (trial % 3 == 0) part.low_y = at_parts(box, 0, inset).y;
    std::vector<bool> lies(ring.size());
    for (std::uint32_t k = 0; k < ring.size(); ++k) {
      lies[k] = ring.lies_within(k, box, part);
      within += lies[k] ? 1 : 0;
    }
    for (int step = 0; step < 41 * 41; ++step) {
      const RealVec at = at_parts(box, step % 41 / 40.0, step / 41 / 40.0);
      const std::uint32_t wedge = ring.facing(at);
      if (!lies[wedge] || ring.depth(wedge, at) > 0) continue;
      ++found;
      const bool in_part = part.low_x <= at.x && at.x <= part.high_x && part.low_y <= at.y && at.y <= part.high_y;
      EXPECT_TRUE(in_part) << "trial " << trial << ", step " << step;
    }
  }
  EXPECT_GT(within, 1000);
  EXPECT_GT(found, 3000);
}

TEST(WedgeRing, FacesTheWedgeOfAPoint) {
  SumCache sums;
  const auto square = sums.outline({{-500, -500}, {500, -500}, {500, 500}, {-500, 500}});
  const auto obstacle = sums.obstacle({square, {}}, {square, {}});
  const WedgeRing ring = rings_of(obstacle, {}).front();
  ASSERT_EQ(ring.size(), 4U);  // parallel sides make one edge
  for (const RealVec p : {RealVec{1100, 1}, RealVec{1, 1100}, RealVec{-1100, 1}, RealVec{1, -1100}}) {
    const std::uint32_t wedge = ring.facing(p);
    EXPECT_NEAR(ring.depth(wedge, p), -100 - kLineSlack, 1e-9);
    EXPECT_NEAR(ring.line(wedge).room(p), 100, 1e-9);
  }
  EXPECT_EQ(ring.corner_near({900, 800}, 0), ring.corner_near({800, -900}, 1));
}

TEST(Hull, ContainsAllPoints) {
  test::Random random{9};
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<RealVec> points;
    for (int k = 0; k < 30; ++k) points.push_back(geometry::real(random.point(0, 10'000)));
    std::vector<RealVec> sorted = points;
    std::vector<HalfPlane> planes;
    append_hull(sorted, planes);
    EXPECT_GT(planes.size(), 2U);
    for (const RealVec p : points) {
      for (const HalfPlane& plane : planes) EXPECT_GE(plane.room(p), 0);
    }
    // Every plane touches some point, except for the slack.
    for (const HalfPlane& plane : planes) {
      const auto touches = [&](RealVec p) { return plane.room(p) < 2 * kRounding; };
      EXPECT_TRUE(std::any_of(points.begin(), points.end(), touches));
    }
  }
}

}  // namespace
}  // namespace selvage::packing::cells
