// The layouts of failed attempts, from which further attempts start [GVW25].
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/guided_search.h"

namespace selvage::nesting::local_search {

// The `most` layouts that overlap least, in the order of their losses.
class Pool {
 public:
  // REQUIRES: most > 0.  The larger the skew, the more often those that overlap least are drawn; 1: all equally often.
  Pool(std::size_t most, double skew) : most_{most}, skew_{skew} {}

  void add(GuidedSearch::Outcome failed) {
    const auto after = std::upper_bound(
        layouts_.begin(), layouts_.end(), failed,
        [](const GuidedSearch::Outcome& a, const GuidedSearch::Outcome& b) { return a.loss < b.loss; });
    layouts_.insert(after, std::move(failed));
    if (layouts_.size() > most_) layouts_.pop_back();
  }
  // REQUIRES: it is not empty.
  [[nodiscard]] const layout::Layout& draw(layout::Dice& dice) const {
    const double at = std::pow(dice.unit(), skew_) * static_cast<double>(layouts_.size());
    return layouts_[static_cast<std::size_t>(at)].layout;
  }
  void clear() { layouts_.clear(); }

 private:
  std::size_t most_;
  double skew_;
  std::vector<GuidedSearch::Outcome> layouts_;
};

}  // namespace selvage::nesting::local_search
