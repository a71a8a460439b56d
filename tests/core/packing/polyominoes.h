// Polyominoes in a box of unit squares: instances whose answers are known from an exhaustive search over squares.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"
#include "tests/support/random.h"

namespace selvage::test {

// The unit squares of a piece, all at 0 or above, without holes.
using Squares = std::vector<Vec>;

inline constexpr Coord kSquare = 1000;  // lattice units

// `count` squares grown from one, each beside another.
[[nodiscard]] Squares random_squares(Random& random, std::size_t count);

// The squares' outline, a unit square being kSquare wide.
[[nodiscard]] Polygon outline_of(const Squares& squares);

// A marker of these pieces, all at the origin, on a strip of the given width in squares.
[[nodiscard]] Marker marker_of(const std::vector<Squares>& pieces, Coord width);

// Whether the pieces fit into width x length squares without turning.  Rectilinear pieces with whole corners that fit
// at all also fit at whole positions: push them all left, then down.  Tries them all.  REQUIRES: width * length <= 64.
[[nodiscard]] bool fit_on_grid(const std::vector<Squares>& pieces, Coord width, Coord length);

}  // namespace selvage::test
