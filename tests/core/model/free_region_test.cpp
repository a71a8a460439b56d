#include "core/model/free_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/geometry/overlap.h"
#include "core/geometry/separating_translation.h"
#include "tests/core/motion/markers.h"

namespace selvage::model {
namespace {

struct Pair {
  outline::OrientedOutline p, q;
  Polygon p_polygon, q_polygon;

  [[nodiscard]] bool overlaps_at(Vec r) const {
    return geometry::overlap({p_polygon, box_of(p_polygon), {0, 0}}, {q_polygon, box_of(q_polygon), r});
  }
  [[nodiscard]] bool separable_at(Vec r, Coord allowance) const {
    return geometry::separating_translation({p_polygon, box_of(p_polygon), {0, 0}}, {q_polygon, box_of(q_polygon), r},
                                            allowance)
        .has_value();
  }
  [[nodiscard]] bool closer_at(Vec r, Coord distance) const {
    return geometry::closer_than({p_polygon, box_of(p_polygon), {0, 0}}, {q_polygon, box_of(q_polygon), r}, distance);
  }
};

Polygon comb(Coord size) {
  const Coord s = size / 9;
  Polygon polygon{{0, 0}, {9 * s, 0}};
  for (int tooth = 4; tooth >= 0; --tooth) {
    polygon.push_back({(2 * tooth + 1) * s, 6 * s});
    polygon.push_back({2 * tooth * s, 6 * s});
    if (tooth > 0) {
      polygon.push_back({2 * tooth * s, s});
      polygon.push_back({(2 * tooth - 1) * s, s});
    }
  }
  polygon[2].x = 9 * s;
  return polygon;
}

Pair random_pair(std::mt19937& random, bool combs = true) {
  const auto polygon = [&]() -> Polygon {
    switch (random() % 4) {
      case 0:
        return test::rectangle(1000 + static_cast<Coord>(random() % 100'000),
                               1000 + static_cast<Coord>(random() % 100'000));
      case 1:
        if (combs) return comb(90'000);
        [[fallthrough]];
      default: return test::spiky(random, 4 + static_cast<int>(random() % 30), 80'000);
    }
  };
  const auto clean = [](const Polygon& outline) { return clean_polygon(outline)->polygon; };
  const Symmetry a{random() % 2 == 0, static_cast<int>(random() % 4)};
  const Symmetry b{random() % 2 == 0, static_cast<int>(random() % 4)};
  Pair pair{{outline::make_outline(clean(polygon())), a}, {outline::make_outline(clean(polygon())), b}, {}, {}};
  pair.p_polygon = transformed(pair.p.outline->polygon, a);
  pair.q_polygon = transformed(pair.q.outline->polygon, b);
  return pair;
}

Vec random_vec(std::mt19937& random, Coord size) {
  return {static_cast<Coord>(random() % static_cast<std::uint32_t>(2 * size + 1)) - size,
          static_cast<Coord>(random() % static_cast<std::uint32_t>(2 * size + 1)) - size};
}

class FreeRegion : public testing::TestWithParam<RegionRule> {};

TEST_P(FreeRegion, HoldsThePositionAndNoOverlap) {
  std::mt19937 random{42};
  SumCache sums;
  int tried = 0;
  for (int k = 0; k < 300; ++k) {
    const Pair pair = random_pair(random);
    const Vec r = random_vec(random, 200'000);
    if (pair.overlaps_at(r)) continue;
    const auto sides = free_region(sums.obstacle(pair.p, pair.q), r, {GetParam(), 1e9, 0});
    for (const HalfPlane& side : sides) EXPECT_GE(slack_of(side, r), 0);
    for (int sample = 0; sample < 200; ++sample) {
      const Vec x = r + random_vec(random, sample % 2 == 0 ? 300'000 : 5'000);
      const bool inside =
          std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return slack_of(side, x) >= 2; });
      if (!inside) continue;
      ++tried;
      EXPECT_FALSE(pair.overlaps_at(x)) << "pair " << k << " from " << r.x << ',' << r.y << " to " << x.x << ',' << x.y;
    }
  }
  EXPECT_GT(tried, 3'000);
}

TEST_P(FreeRegion, WithASpacingHoldsNoPositionCloserThanIt) {
  std::mt19937 random{43};
  SumCache sums;
  int tried = 0;
  for (int k = 0; k < 200; ++k) {
    const Pair pair = random_pair(random);
    const Coord spacing = 1 + static_cast<Coord>(random() % 3'000);
    const Vec r = random_vec(random, 200'000);
    if (pair.closer_at(r, spacing)) continue;
    const auto sides = free_region(sums.obstacle(pair.p, pair.q), r, {GetParam(), 1e9, spacing});
    const auto d = static_cast<double>(spacing);
    for (const HalfPlane& side : sides) EXPECT_GE(slack_of(side, r), d - 2);
    for (int sample = 0; sample < 100; ++sample) {
      const Vec x = r + random_vec(random, 20'000);
      if (!std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return slack_of(side, x) >= d + 2; }))
        continue;
      ++tried;
      EXPECT_FALSE(pair.closer_at(x, spacing));
    }
  }
  EXPECT_GT(tried, 1'000);
}

TEST_P(FreeRegion, OfAnAllowanceHoldsThePositionAndOnlyAllowedOverlaps) {
  std::mt19937 random{44};
  SumCache sums;
  int inside_sum = 0;
  int tried = 0;
  for (int k = 0; k < 400; ++k) {
    const Pair pair = random_pair(random, false);  // teeth as wide as the gaps leave slots without an end
    const Coord allowance = 2'000 + static_cast<Coord>(random() % 20'000);
    const Vec r = random_vec(random, 150'000);
    if (!pair.separable_at(r, allowance)) continue;
    inside_sum += pair.overlaps_at(r) ? 1 : 0;
    const auto sides = overlap_region(sums.obstacle(pair.p, pair.q), {r, r, allowance}, {GetParam(), 1e9, 0});
    const auto a = static_cast<double>(allowance);
    for (const HalfPlane& side : sides) EXPECT_GE(slack_of(side, r), -a - 3);
    for (int sample = 0; sample < 100; ++sample) {
      const Vec x = r + random_vec(random, 2 * allowance);
      if (!std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return slack_of(side, x) >= 4 - a; }))
        continue;
      ++tried;
      EXPECT_TRUE(pair.separable_at(x, allowance))
          << "pair " << k << " from " << r.x << ',' << r.y << " to " << x.x << ',' << x.y << " with " << allowance;
    }
  }
  EXPECT_GT(inside_sum, 20);
  EXPECT_GT(tried, 1'000);
}

TEST_P(FreeRegion, OfAnAllowanceFollowsTheArcOfANotch) {
  // A square pushed as deep as allowed into the corner of an L: it can move around the corner in both directions.
  const auto notched = outline::make_outline({{0, 0}, {9000, 0}, {9000, 3000}, {3000, 3000}, {3000, 9000}, {0, 9000}});
  const auto square = outline::make_outline(test::rectangle(1000, 1000));
  SumCache sums;
  const Vec r{2920, 2940};  // 100 from the corner
  const auto sides = overlap_region(sums.obstacle({notched, {}}, {square, {}}), {r, r, 100}, {GetParam(), 1e6, 0});
  const auto allows = [&](Vec x) {
    return std::all_of(sides.begin(), sides.end(), [&](const HalfPlane& side) { return slack_of(side, x) >= -102; });
  };
  EXPECT_TRUE(allows(r));
  EXPECT_TRUE(allows({2900, 3000}));
  EXPECT_TRUE(allows({3000, 2900}));
  EXPECT_TRUE(allows({2900, 3500}));
  EXPECT_FALSE(allows({2910, 2930}));
  EXPECT_FALSE(allows({2900, 2900}));
}

TEST_P(FreeRegion, AtAConvexCornerOneSideIsEnough) {
  const auto square = outline::make_outline(test::rectangle(1000, 1000));
  SumCache sums;
  const auto sides = free_region(sums.obstacle({square, {}}, {square, {}}), {1500, 1200}, {GetParam(), 1e6, 0});
  EXPECT_EQ(sides.size(), 1U);
}

TEST_P(FreeRegion, InANotchIsTheNotchItself) {
  // A square in the notch of a cup: the cup's three inner sides.
  const auto cup =
      outline::make_outline({{0, 0}, {900, 0}, {900, 100}, {100, 100}, {100, 900}, {900, 900}, {900, 1000}, {0, 1000}});
  const auto square = outline::make_outline(test::rectangle(300, 300));
  SumCache sums;
  const auto sides = free_region(sums.obstacle({cup, {}}, {square, {}}), {200, 350}, {GetParam(), 1e6, 0});
  EXPECT_EQ(sides.size(), 3U);
  for (const HalfPlane& side : sides) EXPECT_TRUE(side.direction.x == 0 || side.direction.y == 0);
}

INSTANTIATE_TEST_SUITE_P(Rules, FreeRegion, testing::Values(RegionRule::kGreedy, RegionRule::kWalk),
                         [](const auto& param) { return param.param == RegionRule::kGreedy ? "Greedy" : "Walk"; });

}  // namespace
}  // namespace selvage::model
