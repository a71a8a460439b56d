// Random markers with every kind of piece, for testing laws.
#pragma once

#include "core/marker/marker.h"
#include "tests/support/random.h"

namespace selvage::test {

// A valid marker of up to twelve pieces (rectangles, stars, convex polygons, combs, U shapes, needles ...) in rows and
// columns with gaps between them, rotated by multiples of 90 degrees.  Some pieces are locked, some markers have a
// spacing, and extents range from 2^8 to 2^34 lattice units.
[[nodiscard]] Marker random_marker(Random& random);

// The same kind of marker, but its pieces may overlap: it has an overlap allowance and no spacing, and some of its
// pieces have allowances of their own.
[[nodiscard]] Marker random_marker_with_allowances(Random& random);

// The same kind of marker with cloth's rules: selvedges of the strip, and pieces with selvedges of their own, in bands,
// on the fold, of shades, with a nap, and matched to the cloth's pattern; and zones of the cloth, also over each other
// and beyond it.
[[nodiscard]] Marker random_marker_with_rules(Random& random);

// The same marker with every unlocked piece moved by up to `part` of the strip's width, so that pieces may overlap.
[[nodiscard]] Marker perturbed(Random& random, Marker marker, double part);

// The marker mirrored across the strip: y becomes width - y.
[[nodiscard]] Marker mirrored(Marker marker);

// The same marker on a lattice ten times as fine: every coordinate is ten times as large.
[[nodiscard]] Marker on_finer_lattice(Marker marker);

}  // namespace selvage::test
