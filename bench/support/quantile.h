// The quantile of a list of values; `part` = 0.5 gives the median.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace selvage::bench {

// REQUIRES: at least one value.
inline double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace selvage::bench
