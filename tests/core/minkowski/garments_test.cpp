// The laws of sums, tested on the shapes of the garment markers in examples/, in the relative orientations that their
// pieces may have.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/core/minkowski/sum_laws.h"
#include "tests/support/garment.h"
#include "tests/support/random.h"

namespace selvage::test {
namespace {

struct ShapePair {
  Polygon first, second;
  Symmetry relative;
};

// Every pair of shapes of a marker, once unturned and once with a half turn, without repetitions.
std::vector<ShapePair> pairs_of(const Marker& marker) {
  std::set<std::tuple<Polygon, Polygon, Symmetry>> seen;
  std::vector<ShapePair> pairs;
  for (std::size_t i = 0; i < marker.shapes.size(); ++i) {
    for (std::size_t j = i; j < marker.shapes.size(); ++j) {
      for (const Symmetry relative : {Symmetry{}, Symmetry{false, 2}}) {
        const Polygon& p = marker.shapes[i].outline;
        const Polygon& q = marker.shapes[j].outline;
        if (seen.emplace(p, q, relative).second) pairs.push_back({p, q, relative});
      }
    }
  }
  return pairs;
}

class Garments : public ::testing::TestWithParam<const char*> {};

TEST_P(Garments, SumsSatisfyTheLaws) {
  const auto pairs = pairs_of(garment(GetParam()));
  ASSERT_GT(pairs.size(), 500U);
  for (std::size_t k = 0; k < pairs.size(); k += kSlowdown) {
    const auto& [p, q, relative] = pairs[k];
    const auto sum = minkowski::obstacle_sum(*outline::make_outline(p), *outline::make_outline(q), relative);
    const Summands summands{p, q, Symmetry{false, 2}.after(relative)};
    ASSERT_EQ(broken_law(summands, sum), "");
  }
}

INSTANTIATE_TEST_SUITE_P(All, Garments, kGarments, garment_name);

}  // namespace
}  // namespace selvage::test
