#include "core/packing/cells/free_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/outline/outline.h"
#include "tests/support/polygons.h"

namespace selvage::packing::cells {
namespace {

std::vector<WedgeRing> rings_of(const Polygon& p, const Polygon& q, Vec offset) {
  SumCache sums;
  const auto obstacle =
      sums.obstacle({sums.outline(clean_polygon(p)->polygon), {}}, {sums.outline(clean_polygon(q)->polygon), {}});
  std::vector<WedgeRing> rings;
  for (const auto& sum : obstacle.sum().rings()) rings.emplace_back(sum, obstacle, offset);
  return rings;
}

bool contains(const RealBox& box, RealVec p) {
  return box.low_x <= p.x && p.x <= box.high_x && box.low_y <= p.y && p.y <= box.high_y;
}

RealBox box_between(Vec a, Vec b) {
  const RealVec p = geometry::real(a);
  const RealVec q = geometry::real(b);
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

// Law: a position outside all rings stays in what is left of every box that holds it.
TEST(FreeCells, NeverExcludeAFreePosition) {
  test::Random random{17};
  int kept = 0;
  int narrowed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Coord extent = Coord{1} << random.between(5, 34);
    const RealBox range = box_between(random.point(-extent, extent), random.point(-extent, extent));
    FreeCells cells{range};
    std::vector<WedgeRing> rings;
    for (int piece = 0; piece < 3; ++piece) {
      const auto own = rings_of(test::random_polygon(random, extent), test::random_polygon(random, extent),
                                random.point(-extent, extent));
      rings.insert(rings.end(), own.begin(), own.end());
    }
    for (const WedgeRing& ring : rings) cells.exclude(ring);
    for (int box = 0; box < 30; ++box) {
      const auto inside = [&] {
        const Vec p = random.point(-extent, extent);
        return Vec{std::clamp(p.x, static_cast<Coord>(range.low_x), static_cast<Coord>(range.high_x)),
                   std::clamp(p.y, static_cast<Coord>(range.low_y), static_cast<Coord>(range.high_y))};
      };
      const Vec at = inside();
      RealBox asked = box_between(at, inside());
      const auto left = cells.within(asked);
      if (left) {
        EXPECT_TRUE(contains(asked, {left->low_x, left->low_y}) || left->low_x > left->high_x);
        narrowed += left->width() < asked.width() || left->height() < asked.height() ? 1 : 0;
      }
      const RealVec p = geometry::real(at);
      if (!std::ranges::all_of(rings, [&](const WedgeRing& ring) { return ring.is_free(p); })) continue;
      ++kept;
      ASSERT_TRUE(left && contains(*left, p)) << "trial " << trial;
    }
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(narrowed, 100);
}

// Two squares that overlap exclude a box that neither of them does.
TEST(FreeCells, ExcludeWhatRingsExcludeTogether) {
  const Polygon square{{0, 0}, {10'000, 0}, {10'000, 10'000}, {0, 10'000}};
  FreeCells cells{{0, 0, 64'000, 64'000}};
  for (const Vec at : {Vec{10'000, 20'000}, Vec{25'000, 20'000}}) {
    for (const WedgeRing& ring : rings_of(square, square, at)) cells.exclude(ring);
  }
  // The sums are squares of twice the size: from (0, 10000) to (20000, 30000), and 15000 to the right of that.
  EXPECT_FALSE(cells.within({5'000, 15'000, 30'000, 25'000}));
  const auto left = cells.within({5'000, 15'000, 30'000, 40'000});
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->low_y, 29'000, 1'001);
  EXPECT_EQ(left->high_y, 40'000);
  EXPECT_EQ(left->low_x, 5'000);
  EXPECT_EQ(left->high_x, 30'000);
}

}  // namespace
}  // namespace selvage::packing::cells
