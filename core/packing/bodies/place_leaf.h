// From the solution of a leaf to a layout on the lattice that is proved valid.
//
// The rows of a search are moved outwards by a little, so its solutions overlap by a few units.  Here the program of
// the leaf is solved once more, with the exact lines of the wedges that the solution lies in.  Rounding then breaks
// slanted contacts by less than a unit; they get a margin of that size where there is room for it, and bodies without
// room move to lattice points nearby that keep all lines (lattice_point.h), all at once or one after another.  Where
// that does not help, as at corners that keep a spacing, small overlaps are repaired (core/motion/repair/repair.h).
#pragma once

#include "core/packing/bodies/bodies.h"

namespace selvage::packing::bodies {

// Moves the leaf's positions to where its layout is valid, as core/marker/clearance.h proves.  False when no rounding
// of it is, and when the run is stopped before one is found.
[[nodiscard]] bool place_leaf(const Marker& marker, const Bodies& bodies, const Freedom& freedom, const scene::Run& run,
                              branching::Leaf& leaf);

}  // namespace selvage::packing::bodies
