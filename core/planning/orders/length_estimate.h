// How long a marker will be that has not been made yet: length = a * (area of its pieces / width) + b.
//
// `a` is what the gaps between the pieces add, `b` what the two ragged ends cost whatever the marker holds, which is
// why markers of many bundles take less cloth per garment.  Both are fitted to the markers that were made, from a first
// guess that they correct as they become more.  The guess is itself corrected by stored markers of similar garments,
// where there are any: each says a ninth of what a made one does, because its pieces and the care taken with it differ.
// Units: millimetres.
#pragma once

#include <span>

namespace selvage::planning::orders {

struct MadeLength {
  double area{};    // of the pieces
  double length{};  // of the marker
};

class LengthEstimate {
 public:
  explicit LengthEstimate(double width);
  LengthEstimate(double width, std::span<const MadeLength> made, std::span<const MadeLength> stored = {});

  [[nodiscard]] double length_of(double area) const { return slope_ * area / width_ + intercept_; }
  // d length / d area, and the length of nothing: what makes the price of a ratio linear in its bundles.
  [[nodiscard]] double length_per_area() const { return slope_ / width_; }
  [[nodiscard]] double length_of_ends() const { return intercept_; }
  // How much a marker of this estimated length differs from it: the standard deviation, given the markers that the
  // estimate is fitted to, of which there may be none.
  [[nodiscard]] double deviation_at(double length) const;

 private:
  double width_, slope_, intercept_;
  double slope_variance_, covariance_, intercept_variance_;
};

}  // namespace selvage::planning::orders
