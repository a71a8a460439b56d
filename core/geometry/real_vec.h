// A point or a vector between lattice points, in lattice units.  It is rounded, and serves only what need not be exact,
// such as the columns of a linear program, contact points in reports, and kernels of star-shaped polygons.
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

}  // namespace selvage::geometry

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using geometry::RealVec;
}  // namespace selvage
