#include "core/packing/programs/difference_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "tests/support/random.h"

namespace selvage::packing::programs {
namespace {

using Raise = std::tuple<std::size_t, std::size_t, double>;

// All longest paths, by Floyd and Warshall.  With a cycle of positive length they are contradictory.
struct LongestPaths {
  std::vector<std::vector<double>> lower;
  bool contradictory{};
};
LongestPaths longest_paths(std::size_t size, const std::vector<Raise>& raises) {
  constexpr double kUnknown = -1e18;
  LongestPaths paths{std::vector(size, std::vector(size, kUnknown))};
  for (std::size_t k = 0; k < size; ++k) paths.lower[k][k] = 0;
  for (const auto& [a, b, bound] : raises) paths.lower[a][b] = std::max(paths.lower[a][b], bound);
  for (std::size_t via = 0; via < size; ++via) {
    for (std::size_t a = 0; a < size; ++a) {
      for (std::size_t b = 0; b < size; ++b)
        paths.lower[a][b] = std::max(paths.lower[a][b], paths.lower[a][via] + paths.lower[via][b]);
    }
  }
  for (std::size_t k = 0; k < size; ++k) paths.contradictory = paths.contradictory || paths.lower[k][k] > 0;
  return paths;
}

TEST(DifferenceBounds, AreClosedByLongestPaths) {
  test::Random random{17};
  int contradictions = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const std::size_t points = 2 + random.below(5);
    DifferenceBounds bounds{points};
    std::vector<Raise> raises;
    for (int k = 0; k < 25; ++k) {
      const std::size_t a = random.below(points + 1);
      const std::size_t b = (a + 1 + random.below(points)) % (points + 1);
      const auto bound = static_cast<double>(random.between(-1000, 100));
      raises.emplace_back(a, b, bound);
      const bool consistent = bounds.raise(a, b, bound);
      const LongestPaths expected = longest_paths(points + 1, raises);
      ASSERT_EQ(consistent, !expected.contradictory);
      contradictions += consistent ? 0 : 1;
      if (!consistent) break;
      for (std::size_t u = 0; u <= points; ++u) {
        for (std::size_t w = 0; w <= points; ++w) {
          if (expected.lower[u][w] < -1e17) continue;
          ASSERT_EQ(bounds.lower(u, w), expected.lower[u][w]);
          ASSERT_EQ(bounds.upper(w, u), -expected.lower[u][w]);
        }
      }
    }
  }
  EXPECT_GT(contradictions, 50);
}

// The raises that the reasons name; raise k belongs to decision k.
std::vector<Raise> named(const std::vector<Raise>& raises, Reasons why) {
  std::vector<Raise> some;
  for (std::size_t k = 0; k < raises.size(); ++k) {
    if ((why & decision(k)) != 0) some.push_back(raises[k]);
  }
  return some;
}

TEST(DifferenceBounds, FollowFromTheirReasonsAlone) {
  test::Random random{19};
  std::size_t fewer = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t points = 3 + random.below(4);
    DifferenceBounds bounds{points};
    std::vector<Raise> raises;
    for (std::size_t k = 0; k < 25; ++k) {
      const std::size_t a = random.below(points + 1);
      const std::size_t b = (a + 1 + random.below(points)) % (points + 1);
      const auto bound = static_cast<double>(random.between(-1000, 100));
      raises.emplace_back(a, b, bound);
      if (!bounds.raise(a, b, bound, decision(k))) {
        const Reasons conflict = decision(k) | bounds.why_upper(a, b);
        ASSERT_TRUE(longest_paths(points + 1, named(raises, conflict)).contradictory);
        fewer += named(raises, conflict).size() < raises.size() ? 1 : 0;
        break;
      }
      const std::size_t u = random.below(points + 1);
      const std::size_t w = (u + 1 + random.below(points)) % (points + 1);
      if (bounds.lower(u, w) < -1e12) continue;
      ASSERT_GE(longest_paths(points + 1, named(raises, bounds.why_lower(u, w))).lower[u][w], bounds.lower(u, w));
    }
  }
  EXPECT_GT(fewer, 50U);
}

}  // namespace
}  // namespace selvage::packing::programs
