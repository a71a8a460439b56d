// The layouts of failed attempts.
#include "core/nesting/local_search/pool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace selvage::nesting::local_search {
namespace {

// A layout that is told by its length.
GuidedSearch::Outcome failed(double length, double loss) {
  layout::Layout layout;
  layout.length = length;
  return {layout, loss};
}

// How often each layout is drawn, by its length.
std::map<double, int> drawn(const Pool& pool, int draws) {
  layout::Dice dice{1};
  std::map<double, int> times;
  for (int k = 0; k < draws; ++k) ++times[pool.draw(dice).length];
  return times;
}

TEST(Pool, KeepsTheLayoutsThatOverlapLeast) {
  Pool pool{2, 1};
  pool.add(failed(1, 30));
  pool.add(failed(2, 10));
  pool.add(failed(3, 40));
  pool.add(failed(4, 20));
  const auto times = drawn(pool, 100);
  EXPECT_EQ(times.size(), 2U);
  EXPECT_TRUE(times.contains(2));
  EXPECT_TRUE(times.contains(4));
}

TEST(Pool, OfEqualOverlapKeepsTheFirst) {
  Pool pool{1, 1};
  pool.add(failed(1, 10));
  pool.add(failed(2, 10));
  EXPECT_TRUE(drawn(pool, 10).contains(1));
}

TEST(Pool, DrawsThoseThatOverlapLessMoreOften) {
  Pool level{4, 1};
  Pool skewed{4, 3};
  for (int k = 1; k <= 4; ++k) {
    level.add(failed(k, k));
    skewed.add(failed(k, k));
  }
  for (const auto& [length, times] : drawn(level, 1000)) EXPECT_NEAR(times, 250, 60) << length;
  const auto times = drawn(skewed, 1000);
  EXPECT_NEAR(times.at(1), 1000 * std::cbrt(0.25), 60);  // u^3 < 1/4
  EXPECT_GT(times.at(1), times.at(2));
  EXPECT_GT(times.at(2), times.at(3));
}

TEST(Pool, IsFilledAnewWhenCleared) {
  Pool pool{4, 1};
  pool.add(failed(1, 1));
  pool.clear();
  pool.add(failed(2, 2));
  EXPECT_FALSE(drawn(pool, 20).contains(1));
}

}  // namespace
}  // namespace selvage::nesting::local_search
