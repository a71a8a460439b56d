// Tests of the cache of sums and of obstacles (core/minkowski/cache.h): sharing, eviction, counts and threads.
#include "core/minkowski/cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/minkowski/nearest_edges.h"
#include "tests/support/placed.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

std::vector<Symmetry> all_symmetries() {
  std::vector<Symmetry> all;
  for (const bool flip : {false, true}) {
    for (int q = 0; q < 4; ++q) all.emplace_back(flip, q);
  }
  return all;
}

// The obstacle's edges in the marker's frame.
std::vector<std::pair<Vec, Vec>> edges_of(const minkowski::Obstacle& obstacle) {
  std::vector<std::pair<Vec, Vec>> edges;
  for (const minkowski::convolution::SumEdge& e : obstacle.sum().edges())
    edges.emplace_back(obstacle.from_frame(e.from), obstacle.from_frame(e.to));
  return edges;
}

TEST(Cache, CountsHitsAndMisses) {
  SumCache sums;
  const auto p = sums.outline({{0, 0}, {40, 0}, {0, 30}});
  const auto q = sums.outline({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  EXPECT_EQ(sums.counts().entries, 0U);
  EXPECT_EQ(sums.counts().limit, SumCache::kDefaultLimit);
  const minkowski::Obstacle first = sums.obstacle({p, {}}, {q, {}});
  EXPECT_EQ(sums.counts().misses, 1U);
  EXPECT_EQ(sums.counts().bytes, p->bytes() + q->bytes() + first.sum().bytes());
  const minkowski::Obstacle again = sums.obstacle({p, {}}, {q, {}});
  EXPECT_EQ(&again.sum(), &first.sum());
  EXPECT_EQ(sums.counts().hits, 1U);
  EXPECT_EQ(sums.counts().misses, 1U);
  EXPECT_EQ(sums.counts().entries, 1U);
}

TEST(Cache, RemembersSimplifiedOutlines) {
  SumCache sums;
  const auto notched = sums.outline({{0, 0}, {50, 3}, {100, 0}, {100, 100}, {0, 100}});
  const auto grown = sums.grown(notched, 10);
  EXPECT_EQ(grown->polygon, (Polygon{{0, 0}, {100, 0}, {100, 100}, {0, 100}}));
  EXPECT_EQ(sums.grown(notched, 10), grown);
  EXPECT_EQ(sums.outline(grown->polygon), grown);
  EXPECT_EQ(sums.grown(notched, 2), notched);
  EXPECT_EQ(sums.grown(grown, 10), grown);
}

TEST(Cache, SharesSumsThatDifferOnlyByTheirFrame) {
  SumCache sums;
  const auto p = sums.outline({{0, 0}, {40, 0}, {0, 30}});
  const auto q = sums.outline({{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  for (const Symmetry common : all_symmetries()) {
    const Symmetry turned = common.after(Symmetry{false, 1});
    (void)sums.obstacle({p, common}, {q, turned});  // the same relative orientation
    (void)sums.obstacle({q, turned}, {p, common});  // the same pair in the other order
  }
  EXPECT_EQ(sums.counts().entries, 1U);
  EXPECT_EQ(sums.counts().misses, 1U);
  EXPECT_EQ(sums.counts().hits, 15U);
}

TEST(Cache, IdentifiesOutlinesByTheirPolygon) {
  SumCache sums;
  const Polygon polygon{{0, 0}, {40, 0}, {0, 30}};
  EXPECT_EQ(sums.outline(polygon), sums.outline(polygon));
  EXPECT_NE(sums.outline(polygon), sums.outline(moved(polygon, {1, 0})));
  // Outlines that were made outside the cache are equal by value.
  const auto mine = sums.outline(polygon);
  (void)sums.obstacle({mine, {}}, {mine, {}});
  (void)sums.obstacle({outline::make_outline(polygon), {}}, {outline::make_outline(polygon), {}});
  EXPECT_EQ(sums.counts().entries, 1U);
  EXPECT_EQ(sums.counts().hits, 1U);
}

TEST(Cache, EvictsTheLeastRecentlyUsedSum) {
  Random random{141};
  std::vector<std::shared_ptr<const outline::Outline>> outlines;
  for (int k = 0; k < 4; ++k) outlines.push_back(outline::make_outline(random_convex(random, 20, 1'000'000)));
  const auto sum_with = [&](SumCache& sums, std::size_t k) {
    return sums.obstacle({outlines[0], {}}, {outlines[k], {}});
  };
  std::size_t bytes = 0;
  {
    SumCache roomy;
    for (std::size_t k = 1; k < 4; ++k) (void)sum_with(roomy, k);
    bytes = roomy.counts().bytes;
    EXPECT_EQ(roomy.counts().entries, 3U);
  }
  SumCache sums{bytes - 1};  // enough for any two of the three sums
  const minkowski::Obstacle kept = sum_with(sums, 1);
  (void)sum_with(sums, 2);
  (void)sum_with(sums, 1);
  (void)sum_with(sums, 3);  // evicts 2, since 1 was used more recently
  EXPECT_EQ(sums.counts().entries, 2U);
  EXPECT_LE(sums.counts().bytes, sums.counts().limit);
  const auto misses = sums.counts().misses;
  (void)sum_with(sums, 1);
  EXPECT_EQ(sums.counts().misses, misses);
  (void)sum_with(sums, 2);
  EXPECT_EQ(sums.counts().misses, misses + 1);
  EXPECT_FALSE(kept.sum().edges().empty());
}

TEST(Cache, CountsOutlinesWithinItsLimit) {
  const auto rectangle = [](Coord width) { return Polygon{{0, 0}, {width, 0}, {width, 30}, {0, 30}}; };
  const std::size_t bytes = outline::make_outline(rectangle(1))->bytes();
  SumCache sums{10 * bytes};
  for (Coord width = 1; width <= 1000; ++width) (void)sums.outline(rectangle(width));
  EXPECT_EQ(sums.counts().bytes, 10 * bytes);
  const std::weak_ptr<const outline::Outline> first = sums.outline(rectangle(991));
  const std::weak_ptr<const outline::Outline> second = sums.outline(rectangle(992));
  EXPECT_FALSE(first.expired());  // the cache holds it
  (void)sums.outline(rectangle(991));
  for (Coord width = 1; width <= 9; ++width) (void)sums.outline(rectangle(width));
  EXPECT_FALSE(first.expired());
  EXPECT_TRUE(second.expired());  // evicted, since 991 was used more recently
}

TEST(Cache, EvictsSimplifiedOutlines) {
  const Polygon notched{{0, 0}, {50, 3}, {100, 0}, {100, 100}, {0, 100}};
  SumCache sums{4 * outline::make_outline(notched)->bytes()};
  const std::weak_ptr<const outline::Outline> first = sums.grown(sums.outline(notched), 10);
  EXPECT_FALSE(first.expired());  // the cache holds it
  for (Coord width = 1; width <= 9; ++width) (void)sums.outline({{0, 0}, {width, 0}, {width, 30}, {0, 30}});
  EXPECT_TRUE(first.expired());
}

TEST(Cache, KeepsOutlinesAsLongAsTheirSums) {
  Random random{145};
  const Polygon p = random_convex(random, 20, 1'000'000);
  const Polygon q = random_convex(random, 20, 1'000'000);
  SumCache roomy;
  (void)roomy.obstacle({roomy.outline(p), {}}, {roomy.outline(q), {}});
  const std::size_t bytes = roomy.counts().bytes;
  SumCache sums{bytes};
  const std::weak_ptr<const outline::Outline> outline = sums.outline(p);
  (void)sums.obstacle({sums.outline(p), {}}, {sums.outline(q), {}});
  EXPECT_EQ(sums.counts().bytes, bytes);
  (void)sums.outline({{0, 0}, {40, 0}, {0, 30}});
  EXPECT_EQ(sums.counts().entries, 0U);  // the sum was evicted before its outlines, although they are older
  EXPECT_FALSE(outline.expired());
}

TEST(Cache, WithoutCapacityStoresNothingAndStillReturnsSums) {
  SumCache sums{0};
  const auto p = sums.outline({{0, 0}, {40, 0}, {0, 30}});
  const minkowski::Obstacle first = sums.obstacle({p, {}}, {p, {}});
  const minkowski::Obstacle second = sums.obstacle({p, {}}, {p, {}});
  EXPECT_EQ(sums.counts().entries, 0U);
  EXPECT_EQ(sums.counts().bytes, 0U);
  EXPECT_EQ(sums.counts().misses, 2U);
  EXPECT_EQ(edges_of(first), edges_of(second));
}

// A cache with another history, or one that evicts its entries, returns the same sums.
TEST(Cache, ResultsDoNotDependOnItsContents) {
  Random random{142};
  std::vector<Polygon> polygons;
  for (int k = 0; k < 6; ++k) polygons.push_back(random_polygon(random, 100'000));
  SumCache full;
  SumCache small{100'000};
  for (int trial = 0; trial < 2000; ++trial) {
    const Polygon& p = polygons[random.below(polygons.size())];
    const Polygon& q = polygons[random.below(polygons.size())];
    const Symmetry a = random.symmetry();
    const Symmetry b = random.symmetry();
    SumCache fresh;
    const auto answer = [&](SumCache& sums) {
      return edges_of(sums.obstacle({sums.outline(p), a}, {sums.outline(q), b}));
    };
    const auto expected = answer(fresh);
    ASSERT_EQ(answer(full), expected);
    ASSERT_EQ(answer(small), expected);
  }
  EXPECT_GT(full.counts().hits, 1000U);
  EXPECT_LE(small.counts().bytes, 100'000U);
}

// A batch request returns the same obstacles as single requests and leaves the cache in the same state; a sum that
// occurs twice is computed once.
TEST(Cache, BatchRequestsEqualSingleRequests) {
  Random random{146};
  std::vector<outline::OrientedOutline> pieces;
  for (int k = 0; k < 12; ++k) {
    const auto outline = outline::make_outline(random_polygon(random, 100'000));
    pieces.push_back({outline, random.symmetry()});
    pieces.push_back({outline, random.symmetry()});
  }
  std::vector<minkowski::OutlinePair> pairs;
  for (int k = 0; k < 300; ++k) {
    const outline::OrientedOutline& p = pieces[random.below(pieces.size())];
    pairs.emplace_back(&p, &pieces[random.below(pieces.size())]);
  }
  SumCache one_by_one;
  SumCache at_once;
  for (const std::size_t known : {0U, 40U, 300U}) {
    const std::span<const minkowski::OutlinePair> asked = std::span{pairs}.first(known);
    (void)at_once.obstacles(asked, serial());
    const auto found = at_once.obstacles(pairs, serial());
    ASSERT_EQ(found.size(), pairs.size());
    for (const auto& [p, q] : asked) (void)one_by_one.obstacle(*p, *q);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      ASSERT_EQ(edges_of(found[k]), edges_of(one_by_one.obstacle(*pairs[k].first, *pairs[k].second)));
    }
    EXPECT_EQ(at_once.counts().hits, one_by_one.counts().hits);
    EXPECT_EQ(at_once.counts().misses, one_by_one.counts().misses);
    EXPECT_EQ(at_once.counts().entries, one_by_one.counts().entries);
    EXPECT_EQ(at_once.counts().bytes, one_by_one.counts().bytes);
  }
  SumCache none{0};
  const auto found = none.obstacles(pairs, serial());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ASSERT_EQ(edges_of(found[k]), edges_of(one_by_one.obstacle(*pairs[k].first, *pairs[k].second)));
  }
}

// q at r overlaps p at 0 exactly when r lies inside the obstacle, for every pair of orientations.
TEST(Obstacle, ContainsExactlyTheOverlappingPositions) {
  Random random{143};
  SumCache sums;
  std::size_t inside = 0;
  std::size_t outside = 0;
  for (int pair = 0; pair < 12; ++pair) {
    const Polygon p = random_polygon(random, 10'000);
    const Polygon q = random_polygon(random, 10'000);
    for (const Symmetry a : all_symmetries()) {
      for (const Symmetry b : all_symmetries()) {
        const minkowski::Obstacle obstacle = sums.obstacle({sums.outline(p), a}, {sums.outline(q), b});
        const Polygon p_image = transformed(p, a);
        const Polygon q_image = transformed(q, b);
        for (int k = 0; k < 20; ++k) {
          const Vec r = random.point(-20'000, 20'000);
          ASSERT_EQ(obstacle.from_frame(obstacle.to_frame(r)), r);
          if (nearest_boundary_point(obstacle.sum(), obstacle.to_frame(r)).distance <= 2) continue;
          const bool overlapping = overlap(placed(p_image), placed(q_image, r));
          ASSERT_EQ(obstacle.sum().contains(real(obstacle.to_frame(r))), overlapping)
              << text_of(p_image) << "; " << text_of(q_image) << " at " << text_of({r});
          ++(overlapping ? inside : outside);
        }
      }
    }
  }
  EXPECT_GT(inside, 2000U);
  EXPECT_GT(outside, 2000U);
}

// True when a move of two units can separate q from p.
bool barely_overlap(const Polygon& p, const Polygon& q, Vec r) {
  for (Coord x = -2; x <= 2; ++x) {
    for (Coord y = -2; y <= 2; ++y) {
      if (!overlap(placed(p), placed(q, r + Vec{x, y}))) return true;
    }
  }
  return false;
}

// At the end points of a whole edge of the sum the two polygons touch.  Only where several star-shaped sums meet may an
// edge be shown that another sum hides by no more than rounding; there alone the polygons may overlap.
TEST(Obstacle, IsExactAtItsVertices) {
  Random random{144};
  SumCache sums;
  std::size_t corners = 0;
  for (int trial = 0; trial < 400 / kSlowdown; ++trial) {
    const Polygon p = random_polygon(random, 100'000);
    const Polygon q = random_polygon(random, 100'000);
    const Symmetry a = random.symmetry();
    const Symmetry b = random.symmetry();
    const minkowski::Obstacle obstacle = sums.obstacle({sums.outline(p), a}, {sums.outline(q), b});
    const Polygon p_image = transformed(p, a);
    const Polygon q_image = transformed(q, b);
    for (const minkowski::convolution::SumEdge& e : obstacle.sum().edges()) {
      if (e.from != e.line_from || e.to != e.line_to) continue;
      ++corners;
      for (const Vec end : {e.from, e.to}) {
        const Vec r = obstacle.from_frame(end);
        const bool overlapping = overlap(placed(p_image), placed(q_image, r));
        ASSERT_FALSE(overlapping && obstacle.sum().rings().size() == 1) << text_of(p_image) << "; " << text_of(q_image);
        ASSERT_TRUE(barely_overlap(p_image, q_image, r)) << text_of(p_image) << "; " << text_of(q_image);
        ASSERT_TRUE(closer_than(placed(p_image), placed(q_image, r), 1));
      }
    }
  }
  EXPECT_GT(corners, 5000U / kSlowdown);
}

TEST(Cache, CanBeSharedByThreads) {
  Random random{145};
  std::vector<Polygon> polygons;
  for (int k = 0; k < 8; ++k) polygons.push_back(random_polygon(random, 10'000));
  SumCache sums{200'000};  // so small that entries are evicted while others are in use
  const auto hammer = [&](std::uint64_t seed) {
    Random mine{seed};
    for (int k = 0; k < 1500; ++k) {
      const auto p = sums.outline(polygons[mine.below(polygons.size())]);
      const auto q = sums.outline(polygons[mine.below(polygons.size())]);
      const Symmetry a = mine.symmetry();
      const minkowski::Obstacle obstacle = sums.obstacle({p, a}, {q, mine.symmetry()});
      ASSERT_FALSE(obstacle.sum().edges().empty());
    }
  };
  std::thread first{hammer, 1};
  std::thread second{hammer, 2};
  first.join();
  second.join();
  const minkowski::CacheCounts counts = sums.counts();
  EXPECT_EQ(counts.hits + counts.misses, 3000U);
  EXPECT_LE(counts.bytes, counts.limit);
  EXPECT_GT(counts.entries, 0U);
}

}  // namespace
}  // namespace selvage::test
