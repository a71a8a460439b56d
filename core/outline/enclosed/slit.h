// Holes of a shape that are open, so that other pieces may lie in them.
//
// An outline is a simple polygon.  A slit between two corners joins a hole to the outside: the boundary leads in along
// one side of the slit, around the hole clockwise, and out along the other side.  The result is an outline like any
// other, so sums, rows and proofs need nothing new.  A slit is kSlit lattice units wide, and nothing that is wider
// passes through it; the cloth that it takes from the piece is of the order of what rounding to the lattice does.
// Units: lattice units.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::outline::enclosed {

inline constexpr Coord kSlit = 8;
// A hole is opened, and a slit is recognised, if the hole is at least this large along both axes.
inline constexpr Coord kLeastHole = 64 * kSlit;

// The outline with all holes open.  Nothing if a hole is too small, touches or crosses the outline or another hole,
// lies outside of the outline or inside another hole, or if the result would have more than kMaxVertices.
// REQUIRES: every polygon is as clean_polygon returns it.
[[nodiscard]] std::optional<Polygon> with_open_holes(const Polygon& outline, const std::vector<Polygon>& holes);

struct Rings {
  Polygon outline;
  std::vector<Polygon> holes;  // counter-clockwise
};
// The outline without its slits: the reverse of with_open_holes, also of an outline that has been turned and rounded.
[[nodiscard]] Rings without_slits(Polygon outline);

}  // namespace selvage::outline::enclosed
