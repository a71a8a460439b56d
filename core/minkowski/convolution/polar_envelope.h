// The outer envelope, seen from the origin, of chains of segments that turn counter-clockwise about the origin.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/minkowski/convolution/reduced_convolution.h"

namespace selvage::minkowski::convolution {

// The part of a candidate edge that is visible from the centre: from (x0, y0) to (x1, y1), relative to the centre, over
// the angles [angle0, angle1] (pseudo angles: 0..4 for a full turn from the x axis).
struct Stretch {
  double angle0{}, angle1{};
  double x0{}, y0{}, x1{}, y1{};
  std::uint32_t candidate{};
};

// The outermost segments in counter-clockwise order from the x axis.  They leave no gap when the centre is inside the
// sum.  Nothing when `stopped`, which is asked once for each pass over all segments unless it is empty.
[[nodiscard]] std::optional<std::vector<Stretch>> polar_envelope(std::span<const Candidate> candidates,
                                                                 const std::function<bool()>& stopped);

}  // namespace selvage::minkowski::convolution
