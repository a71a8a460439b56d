// A cheap monotone substitute for the angle of a vector: it grows from 0 to 4 over one counter-clockwise turn from the
// x axis.
#pragma once

#include <cmath>

namespace selvage::geometry {

inline constexpr double kFullTurn = 4;

// REQUIRES: (x, y) is not (0, 0).
[[nodiscard]] inline double pseudo_angle(double x, double y) {
  const double part = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - part;
  return y < 0 ? kFullTurn + part : part;
}

}  // namespace selvage::geometry
