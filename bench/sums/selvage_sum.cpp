#include <optional>

#include "bench/sums/pair_sum.h"
#include "core/minkowski/sum.h"

namespace selvage::bench {
namespace {

// Sums are not cached.  The star-shaped parts of the outlines are computed beforehand, once for all pairs, as in a
// compaction.
class SelvageSum final : public PairSum {
 public:
  explicit SelvageSum(OutlinePair pair) : pair_{std::move(pair)} {}
  void make() override { sum_.emplace(minkowski::obstacle_sum(*pair_.p, *pair_.q, pair_.relative)); }
  [[nodiscard]] test::Difference difference(const test::ExactSum& exact) const override {
    return exact.difference(*sum_);
  }

 private:
  OutlinePair pair_;
  std::optional<minkowski::MinkowskiSum> sum_;
};

}  // namespace

std::unique_ptr<PairSum> selvage_sum(const OutlinePair& pair) {
  return std::make_unique<SelvageSum>(pair);
}

}  // namespace selvage::bench
