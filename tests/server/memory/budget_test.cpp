#include "server/memory/budget.h"

#include <gtest/gtest.h>

namespace selvage::server::memory {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

TEST(Budget, TheWholeIsDivided) {
  for (const std::size_t whole : {128 * kMiB, 1000 * kMiB, 64'000 * kMiB}) {
    const auto budget = divided(whole);
    ASSERT_TRUE(budget);
    EXPECT_EQ(budget->sums + budget->traffic + budget->markers + kProgram, whole);
    EXPECT_LE(budget->sums, 256 * kMiB);
    EXPECT_LE(budget->traffic, 512 * kMiB);
  }
}

TEST(Budget, RequestedPartsAreGranted) {
  const auto budget = divided(1000 * kMiB, 7 * kMiB, 300 * kMiB);
  ASSERT_TRUE(budget);
  EXPECT_EQ(budget->sums, 7 * kMiB);
  EXPECT_EQ(budget->traffic, 300 * kMiB);
  EXPECT_EQ(budget->markers, 693 * kMiB - kProgram);
}

TEST(Budget, MarkersMustHaveRoom) {
  EXPECT_FALSE(divided(64 * kMiB));
  EXPECT_FALSE(divided(1000 * kMiB, 900 * kMiB));
  EXPECT_FALSE(divided(1000 * kMiB, {}, 2000 * kMiB));
  EXPECT_EQ(divided(kProgram + kLeastMarkers + 2 * kMiB, kMiB, kMiB)->markers, kLeastMarkers);
}

}  // namespace
}  // namespace selvage::server::memory
