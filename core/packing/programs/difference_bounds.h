// Lower bounds on the differences of one coordinate of several points, closed by shortest paths.
//
// Point `world()` is the origin, so a difference from it is a coordinate.  Bounds are whole lattice units kept in
// doubles: below 2^53 their sums are exact, so a contradiction between bounds is one of the layout, not of rounding.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/packing/programs/reasons.h"

namespace selvage::packing::programs {

class DifferenceBounds {
 public:
  // Nothing known of `points` points and the origin.
  explicit DifferenceBounds(std::size_t points)
      : size_{points + 1}, lower_(size_ * size_, -4.0 * static_cast<double>(kLatticeLimit)), why_(size_ * size_) {
    for (std::size_t k = 0; k < size_; ++k) lower_[k * size_ + k] = 0;
  }

  [[nodiscard]] std::size_t world() const { return size_ - 1; }
  // The least and the largest value of (coordinate of b) - (coordinate of a).
  [[nodiscard]] double lower(std::size_t a, std::size_t b) const { return lower_[a * size_ + b]; }
  [[nodiscard]] double upper(std::size_t a, std::size_t b) const { return -lower_[b * size_ + a]; }
  // `lower(a, b)` by b.
  [[nodiscard]] const double* lower_from(std::size_t a) const { return &lower_[a * size_]; }

  // Why it is not less than `lower`; why it is not more than `upper`.
  [[nodiscard]] Reasons why_lower(std::size_t a, std::size_t b) const { return why_[a * size_ + b]; }
  [[nodiscard]] Reasons why_upper(std::size_t a, std::size_t b) const { return why_[b * size_ + a]; }

  // Adds that b - a is at least `bound`, with all that follows.  False when the bounds contradict each other: then
  // `bound` is above `upper(a, b)`, which is as it was.
  // REQUIRES: `bound` is whole.
  [[nodiscard]] bool raise(std::size_t a, std::size_t b, double bound, Reasons why = kUnconditional);
  // Makes everything that is known hold unconditionally.
  void forget_why() { std::fill(why_.begin(), why_.end(), kUnconditional); }

 private:
  std::size_t size_;
  std::vector<double> lower_;  // row by row
  std::vector<Reasons> why_;   // of the same bounds
};

}  // namespace selvage::packing::programs
