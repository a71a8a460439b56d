// Points, vectors and boxes between lattice points.  They are rounded, and serve only what need not be exact, such as
// the columns of a linear program, contact points in reports, and kernels of star-shaped polygons.  Their unit is the
// lattice unit, unless it is said otherwise.
#pragma once

#include "core/geometry/lattice.h"

namespace selvage::geometry {

struct RealVec {
  double x{}, y{};
};

// The same point or vector; exact, because lattice coordinates have fewer bits than a double's mantissa.
[[nodiscard]] constexpr RealVec real(Vec v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

// A closed box.
struct RealBox {
  double low_x{}, low_y{}, high_x{}, high_y{};

  [[nodiscard]] double width() const { return high_x - low_x; }
  [[nodiscard]] double height() const { return high_y - low_y; }
  [[nodiscard]] double middle_x() const { return (low_x + high_x) / 2; }
  [[nodiscard]] double middle_y() const { return (low_y + high_y) / 2; }
};

}  // namespace selvage::geometry

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using geometry::RealBox;
using geometry::RealVec;
}  // namespace selvage
