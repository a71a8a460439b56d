#include "core/packing/programs/difference_bounds.h"

#include <algorithm>

namespace selvage::packing::programs {

bool DifferenceBounds::raise(std::size_t a, std::size_t b, double bound, Reasons why) {
  if (bound <= lower(a, b)) return true;
  if (bound > upper(a, b)) return false;
  // The paths u -> a -> b -> w.  Row b itself cannot change, because b -> a -> b would be a contradiction.
  const double* const from_b = &lower_[b * size_];
  const Reasons* const why_from_b = &why_[b * size_];
  for (std::size_t u = 0; u < size_; ++u) {
    const double to_b = lower_[u * size_ + a] + bound;
    double* const row = &lower_[u * size_];
    if (u == b || to_b <= row[b]) continue;
    Reasons* const why_row = &why_[u * size_];
    const Reasons why_to_b = why_row[a] | why;
    for (std::size_t w = 0; w < size_; ++w) {
      const bool higher = to_b + from_b[w] > row[w];
      row[w] = higher ? to_b + from_b[w] : row[w];
      why_row[w] = higher ? why_to_b | why_from_b[w] : why_row[w];
    }
    row[u] = 0;
  }
  return true;
}

}  // namespace selvage::packing::programs
