#include "core/planning/program/generation.h"

#include <algorithm>
#include <numeric>

namespace selvage::planning::program {
namespace {

constexpr std::size_t kPricingNodes = 200'000;  // of one search for the ratio of the least reduced cost

class Pricing {
 public:
  Pricing(const PricingProblem& problem, const std::set<orders::Ratio>& known)
      : problem_{problem}, known_{known}, ratio_(problem.gain.size()), by_gain_(problem.gain.size()) {
    std::iota(by_gain_.begin(), by_gain_.end(), std::size_t{});
    std::stable_sort(by_gain_.begin(), by_gain_.end(),
                     [&](std::size_t a, std::size_t b) { return problem.gain[a] < problem.gain[b]; });
  }

  PricedRatios run() {
    descend(0, problem_.bundles, problem_.capacity, problem_.constant);
    PricedRatios priced{std::move(found_), best_};
    if (nodes_ > kPricingNodes) {
      const double gain = by_gain_.empty() ? 0 : std::min(0.0, problem_.gain[by_gain_.front()]);
      priced.least = problem_.constant + problem_.bundles * gain;
    }
    return priced;
  }

 private:
  // `cost` is that of the sizes before `depth`.
  void descend(std::size_t depth, int bundles, double capacity, double cost) {
    if (++nodes_ > kPricingNodes) return;
    if (depth == by_gain_.size() || bundles == 0) return accept(cost);
    const std::size_t size = by_gain_[depth];
    const double gain = problem_.gain[size];
    if (cost + bundles * std::min(0.0, gain) >= best_) return;
    int most = std::min(bundles, problem_.most[size]);
    while (most > 0 && problem_.weight[size] * most > capacity) --most;
    for (int count = most; count >= 0; --count) {
      ratio_[size] = count;
      descend(depth + 1, bundles - count, capacity - count * problem_.weight[size], cost + count * gain);
    }
    ratio_[size] = 0;
  }

  void accept(double cost) {
    if (cost >= best_ || orders::bundles_in(ratio_) == 0 || known_.contains(ratio_)) return;
    best_ = cost;
    if (cost < 0) found_.push_back(ratio_);
  }

  const PricingProblem& problem_;
  const std::set<orders::Ratio>& known_;
  orders::Ratio ratio_;
  std::vector<std::size_t> by_gain_;
  std::vector<orders::Ratio> found_;
  double best_{1e300};
  std::size_t nodes_{};
};

}  // namespace

PricedRatios price_ratios(const PricingProblem& problem, const std::set<orders::Ratio>& known) {
  return Pricing{problem, known}.run();
}

}  // namespace selvage::planning::program
