// What every answer must be, judged twice: by the product's own integers, and by CGAL's.
#pragma once

#include "core/marker/marker.h"
#include "core/motion/compaction/compact.h"

namespace selvage::test {

// No pair overlaps and no piece leaves the strip, by either judge.  CGAL is asked about every pair whose boxes overlap.
// With SELVAGE_OUTLINES=FOLDER in the environment the layout is kept there as placed outlines, named after the running
// test, for a third judge (tests/judge).
void expect_valid_twice(const Marker& marker);

// The same of a marker that was found valid before some of its pieces moved: CGAL is asked about pairs with these only,
// and about how many is returned.
std::size_t expect_valid_where_moved(const Marker& before, const Marker& after);

// Valid twice; shapes, strip, orientations and locked coordinates are what they were; not longer than before but for
// `lengthened` lattice units.
void expect_sound(const Marker& before, const Marker& after, Coord lengthened = 0);

// Compacted at standard accuracy and found sound; an empty marker, and a failure, when it is refused.
motion::compaction::Compaction soundly_compacted(const Marker& marker);

}  // namespace selvage::test
