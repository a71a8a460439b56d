// Random markers of every kind of piece, for laws that hold of all of them.
#pragma once

#include "core/marker/marker.h"
#include "tests/support/random.h"

namespace selvage::test {

// Valid: up to twelve pieces (rectangles, stars, convex ones, combs, arms, needles ...) in rows and columns with room
// between them, turned by quarter turns; some locked, some markers spaced, extents from 2^8 to 2^34 units.
[[nodiscard]] Marker random_marker(Random& random);

// The same with every piece that is not locked moved a little, by up to `part` of the strip's width: it may overlap.
[[nodiscard]] Marker shaken(Random& random, Marker marker, double part);

// Mirrored across the strip: y becomes width - y.
[[nodiscard]] Marker mirrored(Marker marker);

// Every coordinate ten times as large, on a lattice ten times as fine: the same marker.
[[nodiscard]] Marker on_finer_lattice(Marker marker);

}  // namespace selvage::test
