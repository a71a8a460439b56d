// The laws of sums, tested on random pairs with CGAL's exact sum as reference.
#include <gtest/gtest.h>

#include "tests/core/minkowski/sum_laws.h"
#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

void expect_laws(const Polygon& p, const Polygon& q) {
  const auto sum = minkowski::minkowski_sum(outline::make_outline(p)->parts, outline::make_outline(q)->parts);
  EXPECT_EQ(broken_law({p, q, {}}, sum), "");
}

// With few directions and lengths there are many parallel edges, slots that are filled exactly and holes that shrink to
// a point.  The polygons are scaled up so that rounding is not mistaken for coincidence.
TEST(Oracle, AgreesOnSmallLattices) {
  Random random{101};
  for (int trial = 0; trial < 3000 / kSlowdown && !HasFailure(); ++trial) {
    const Coord factor = random.between(1000, 1'000'000);
    const Polygon p = scaled(random_polygon(random, random.between(4, 16)), factor);
    expect_laws(p, scaled(transformed(random_polygon(random, random.between(2, 12)), random.symmetry()), factor));
  }
}

TEST(Oracle, AgreesOnMediumLattices) {
  Random random{102};
  for (int trial = 0; trial < 3000 / kSlowdown && !HasFailure(); ++trial) {
    const Polygon p = random_polygon(random, random.between(10'000, 1'000'000));
    expect_laws(p, transformed(random_polygon(random, random.between(10'000, 1'000'000)), random.symmetry()));
  }
}

TEST(Oracle, AgreesOnLargeLattices) {
  Random random{103};
  for (int trial = 0; trial < 2000 / kSlowdown && !HasFailure(); ++trial) {
    const Polygon p = random_polygon(random, kLatticeLimit / 4);
    expect_laws(p, transformed(random_polygon(random, kLatticeLimit / random.between(4, 1000)), random.symmetry()));
  }
}

// The sums of the parts are far more than those that are all compared with each other, and many repeat or lie within
// others.
TEST(Oracle, AgreesOnManyTeeth) {
  Random random{104};
  for (int trial = 0; trial < 40 / kSlowdown && !HasFailure(); ++trial) {
    const auto teeth = [&] { return static_cast<std::size_t>(random.between(11, 16)); };
    const Polygon p = random_comb(random, teeth(), 1'000'000, trial % 3 == 0);
    const Polygon q = trial % 2 == 0 ? p : random_comb(random, teeth(), random.between(100'000, 1'000'000), false);
    expect_laws(p, transformed(q, random.symmetry()));
  }
}

}  // namespace
}  // namespace selvage::test
