// Compaction on constructions that show what it cannot do, or only slowly.  It must end with a valid answer; the number
// of rounds is recorded together with the theoretical number (ctest's XML:  "rounds", "k_to_the_n").
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/compaction/hard_instances.h"

namespace selvage::motion::compaction {
namespace {

Compaction compacted_finely(const Marker& marker) {
  EXPECT_TRUE(is_valid(marker));
  CompactionSettings settings = compaction_settings(Accuracy::kFine);
  settings.rounds = 2000;
  settings.trust = 0.1;
  SumCache sums;
  const auto result = compact(marker, settings, {sums});
  EXPECT_TRUE(static_cast<bool>(result));
  EXPECT_TRUE(is_valid(result->marker));
  EXPECT_LE(result->length_after, result->length_before);
  EXPECT_TRUE(result->reason == scene::StopReason::kConverged || result->reason == scene::StopReason::kWorkLimit);
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    EXPECT_TRUE(!marker.pieces[i].locked || result->marker.pieces[i].at == marker.pieces[i].at);
  }
  testing::Test::RecordProperty("rounds", result->rounds);
  testing::Test::RecordProperty("programs", result->programs);
  return *result;
}
double units(Coord length) {
  return static_cast<double>(length) / static_cast<double>(test::kUnit);
}

class Partition : public testing::TestWithParam<std::vector<int>> {};
TEST_P(Partition, EndsBetweenHalfTheSumAndTheWhole) {
  const int sum = std::accumulate(GetParam().begin(), GetParam().end(), 0);
  const Compaction result = compacted_finely(test::partition(GetParam()));
  testing::Test::RecordProperty("length", std::to_string(units(result.length_after)));
  EXPECT_GE(units(result.length_after), sum / 2.0 - 1e-9);
  EXPECT_LE(units(result.length_after), sum);
}
INSTANTIATE_TEST_SUITE_P(HardInstances, Partition,
                         testing::Values(std::vector{3, 1, 1, 2, 2, 1}, std::vector{2, 3, 4, 5, 6, 10},
                                         std::vector{7, 7, 7, 7, 7}, std::vector{1, 2, 4, 8, 16, 31},
                                         std::vector{5, 3, 8, 1, 9, 4, 6, 2, 7, 5, 8, 10}));

class Bars : public testing::TestWithParam<int> {};
TEST_P(Bars, HoldTheUShapesWhereTheyAre) {  // no way out that only ever shortens: 4 n + 2 is out of reach
  const int n = GetParam();
  const Marker marker = test::u_shapes_and_bars(n);
  EXPECT_DOUBLE_EQ(units(length_of(marker)), 6 * n + 2);
  const Compaction result = compacted_finely(marker);
  EXPECT_GT(units(result.length_after), 4 * n + 2);
}
INSTANTIATE_TEST_SUITE_P(HardInstances, Bars, testing::Values(2, 3, 4, 6));

// Each flank of a tooth is a separate convex region, so a stroke of the last follower takes at least one round [Li94
// Theorem 9.4].
class Propagation : public testing::TestWithParam<std::tuple<int, int>> {};
TEST_P(Propagation, ReachesTheEndInMoreThanKToTheNRounds) {
  const auto [n, k] = GetParam();
  const Compaction result = compacted_finely(test::motion_propagation(n, k));
  const double theory = std::pow(k, n);
  const double shortened = units(result.length_before - result.length_after);
  testing::Test::RecordProperty("k_to_the_n", static_cast<int>(theory));
  std::printf("| %d | %d | %.0f | %d | %d | %.3f |\n", n, k, theory, result.rounds, result.programs, shortened);
  EXPECT_GE(shortened, k);
  EXPECT_LE(shortened, k + 0.5);  // the channel ends
  EXPECT_GE(result.rounds, theory);
}
INSTANTIATE_TEST_SUITE_P(HardInstances, Propagation,
                         testing::Values(std::tuple{1, 2}, std::tuple{1, 3}, std::tuple{1, 4}, std::tuple{1, 6},
                                         std::tuple{2, 2}, std::tuple{2, 3}, std::tuple{2, 4}, std::tuple{3, 2},
                                         std::tuple{3, 3}));

}  // namespace
}  // namespace selvage::motion::compaction
