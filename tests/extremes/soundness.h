// Expectations that every result must meet, checked both by Selvage's exact predicates and by CGAL.
#pragma once

#include "core/marker/marker.h"
#include "core/motion/compaction/compact.h"

namespace selvage::test {

// Expects that no pair overlaps and no piece leaves the strip, according to both.  CGAL tests every pair whose boxes
// overlap.
// When the environment variable SELVAGE_OUTLINES is set to a folder, the layout is also saved there as placed outlines,
// named after the running test, for an independent judge (tests/judge).
void expect_valid_twice(const Marker& marker);

// The same for a marker that was valid before some of its pieces moved.  CGAL tests only pairs with a moved piece;
// returns their number.
std::size_t expect_valid_where_moved(const Marker& before, const Marker& after);

// Expects a valid marker with the same shapes, strip, orientations and locked coordinates, longer than before by at
// most `lengthened` lattice units.
void expect_sound(const Marker& before, const Marker& after, Coord lengthened = 0);

// Compacts at standard accuracy and expects a sound result.  When the marker is rejected, the test fails and the result
// is empty.
motion::compaction::Compaction soundly_compacted(const Marker& marker);

}  // namespace selvage::test
