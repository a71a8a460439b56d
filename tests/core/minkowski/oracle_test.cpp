// Sums of random pairs against CGAL's.
#include <gtest/gtest.h>

#include "tests/core/minkowski/sum_laws.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

void judge(const Polygon& p, const Polygon& q) {
  const auto sum = minkowski::minkowski_sum(outline::make_outline(p)->parts, outline::make_outline(q)->parts);
  EXPECT_EQ(broken_law({p, q, {}}, sum), "");
}

// Few directions and lengths: parallel edges, slots that are filled without any room, holes that close to a
// point.  Spread out by a factor, so that rounding stays apart from coincidence.
TEST(Oracle, OnSmallLattices) {
  Random random{101};
  for (int trial = 0; trial < 3000 / kSlowdown && !HasFailure(); ++trial) {
    const Coord factor = random.between(1000, 1'000'000);
    const Polygon p = scaled(random_polygon(random, random.between(4, 16)), factor);
    judge(p, scaled(transformed(random_polygon(random, random.between(2, 12)), random.symmetry()), factor));
  }
}

TEST(Oracle, OnMiddlingLattices) {
  Random random{102};
  for (int trial = 0; trial < 3000 / kSlowdown && !HasFailure(); ++trial) {
    const Polygon p = random_polygon(random, random.between(10'000, 1'000'000));
    judge(p, transformed(random_polygon(random, random.between(10'000, 1'000'000)), random.symmetry()));
  }
}

TEST(Oracle, OnLargeLattices) {
  Random random{103};
  for (int trial = 0; trial < 2000 / kSlowdown && !HasFailure(); ++trial) {
    const Polygon p = random_polygon(random, kLatticeLimit / 4);
    judge(p, transformed(random_polygon(random, kLatticeLimit / random.between(4, 1000)), random.symmetry()));
  }
}

}  // namespace
}  // namespace selvage::test
