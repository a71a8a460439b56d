// Tests of runs with a limit on time.
#include "core/nesting/timed_run.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/minkowski/cache.h"
#include "tests/support/polygons.h"

namespace selvage::nesting {
namespace {

TEST(TimedRun, EndsWhileItComputesTheSumsOfAStage) {
  test::Random random{5};
  SumCache sums;
  std::vector<outline::OrientedOutline> outlines;
  for (int k = 0; k < 12; ++k) outlines.push_back({sums.outline(test::random_star(random, 20, 100'000)), {}});
  std::vector<minkowski::OutlinePair> pairs;
  for (std::size_t k = 1; k < outlines.size(); ++k) pairs.emplace_back(&outlines[k - 1], &outlines[k]);
  int readings = 0;
  const TimedRun timed{{sums}, [&readings] { return ++readings < 40 ? 0.0 : 1.0; }};
  EXPECT_TRUE(sums.obstacles(pairs, *timed.run().executor, timed.run().stop).empty());
  EXPECT_TRUE(timed.run().stopped());
  EXPECT_GT(sums.counts().entries, 0U);
  EXPECT_LT(sums.counts().entries, pairs.size());
  EXPECT_LT(readings, 40 + static_cast<int>(pairs.size()));  // one for each sum that is not begun
}

}  // namespace
}  // namespace selvage::nesting
