// What two polygons have in common when one of them is moved to where it covers most of the other.
//
// The place is chosen by areas that are sampled on lines, so it is not quite the best one.  That the part lies within
// both polygons is tested exactly.
// REQUIRES everywhere: polygons of at most kMostCorners corners.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <span>

#include "core/geometry/polygon.h"

namespace selvage::packing::cores {

inline constexpr std::size_t kMostCorners = geometry::kMaxVertices / 4;  // with those of its box, far below the limit

// Where one polygon covers much of another.
struct Fit {
  Vec by;         // by which it is moved
  double area{};  // of the part that it then has in common with the other, about
};
// Where q covers much of p.  Of the intersection of their boxes, no other place leaves more in width or in height:
// wide and high pieces are what is in the way of others.
[[nodiscard]] Fit best_fit(std::span<const Vec> p, std::span<const Vec> q);

// The largest connected part of the two polygons' intersection, smaller by some units so that rounding does not bring
// its corners outside.  Empty when there is none, when it has holes or more than kMostCorners corners.
// Law.  It lies within both polygons, tested in integers.
[[nodiscard]] Polygon common_part(const Polygon& p, const Polygon& q);

// Whether the inner polygon lies within the outer one, which it may touch.  Exact.
[[nodiscard]] bool lies_within(const Polygon& inner, const Polygon& outer);

}  // namespace selvage::packing::cores
