// Tests of core/outline/enclosed/free_area.h against CGAL's exact set operations.
#include "core/outline/enclosed/free_area.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/outline/enclosed/container.h"
#include "tests/support/exact.h"
#include "tests/support/polygons.h"

namespace selvage::outline::enclosed {
namespace {

TEST(FreeArea, IsThatOfTheRegionWithoutHoles) {
  const Polygon triangle{{0, 0}, {10, 0}, {0, 10}};
  EXPECT_EQ(free_area(triangle, {}), 50);
  const std::vector<Polygon> all{{{-5, -5}, {20, -5}, {20, 20}, {-5, 20}}};
  EXPECT_EQ(free_area(triangle, all), 0);
}

TEST(FreeArea, CountsOverlapsOfHolesOnceAndNothingBeyondTheEdge) {
  test::Random random{17};
  for (int trial = 0; trial < 60 / test::kSlowdown; ++trial) {
    const Polygon region = test::random_star(random, 24, 10'000);
    std::vector<Polygon> holes;
    for (std::int64_t k = random.between(0, 6); k > 0; --k) {
      const Vec by{random.between(-10'000, 10'000), random.between(-10'000, 10'000)};
      holes.push_back(moved(test::random_star(random, 8, random.between(100, 6'000)), by));
    }
    const Container container{region};
    std::vector<Polygon> taken = container.walls;
    taken.insert(taken.end(), holes.begin(), holes.end());
    const std::vector<double> areas = test::areas_left_over(container.box, taken);
    const double exact = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECT_NEAR(free_area(region, holes), exact, 1e-3) << "trial " << trial;
  }
}

}  // namespace
}  // namespace selvage::outline::enclosed
