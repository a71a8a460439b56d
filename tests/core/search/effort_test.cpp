#include "core/search/effort.h"

#include <gtest/gtest.h>

namespace selvage::search {
namespace {

constexpr Coord kStart = 10'000;

TEST(Effort, EndsWithTheMostWork) {
  Effort effort{1'000, 1'000, kStart};
  effort.spend(999, kStart - 50);
  EXPECT_FALSE(effort.enough());
  effort.spend(1, kStart - 50);
  EXPECT_TRUE(effort.enough());
}

TEST(Effort, EndsAfterAThirdOfTheLeastWorkWhenNothingWasGained) {
  Effort effort{3'000, 100'000, kStart};
  effort.spend(999, kStart);
  EXPECT_FALSE(effort.enough());
  effort.spend(1, kStart);
  EXPECT_TRUE(effort.enough());
}

TEST(Effort, ContinuesWhileTheLastNineTenthsOfTheWorkHaveGained) {
  Effort effort{1'000, 1'000'000, kStart};
  effort.spend(150, kStart - 89);
  effort.spend(500, kStart - 100);  // more than a tenth of the gain, after a tenth of the work
  effort.spend(800, kStart - 100);
  EXPECT_EQ(effort.spent(), 1'450U);
  EXPECT_FALSE(effort.enough());
  effort.spend(100, kStart - 100);  // now 89 of the 100 were gained in the first tenth
  EXPECT_FALSE(effort.enough());
  effort.spend(5'000, kStart - 100);
  EXPECT_TRUE(effort.enough());
  effort.spend(10, kStart - 200);
  EXPECT_FALSE(effort.enough());
}

TEST(Effort, CountsTheGainBeforeTheFirstWork) {
  Effort effort{1'000, 100'000, kStart};
  effort.spend(0, kStart - 100);
  effort.spend(900, kStart - 110);  // a tenth of what had been gained
  effort.spend(100, kStart - 110);
  EXPECT_TRUE(effort.enough());
}

TEST(Effort, IgnoresLongerMarkers) {
  Effort effort{1'000, 100'000, kStart};
  effort.spend(500, kStart - 100);
  effort.spend(500, kStart - 20);
  EXPECT_FALSE(effort.enough());
  effort.spend(4'000, kStart - 20);
  EXPECT_TRUE(effort.enough());
}

}  // namespace
}  // namespace selvage::search
