// Relaxed markers: pieces that are nearly alike are replaced by a common core, a smaller outline that lies within all
// of them, or within one piece in all of its orientations.
//
// Argument.  Take a layout of the given pieces.  Put each core into its piece, where it lies within it by a lattice
// translation: it overlaps nothing that its piece does not overlap, comes no nearer to anything, and stays inside every
// container.  So where the cores do not fit, the pieces do not either.  Pieces with one core are interchangeable, and a
// piece with a core of all its orientations needs no orientation: a search for the cores has far fewer cases.
// Only pieces without rules, locks, groups and tilts are replaced, of one buffer together.  Their orientations are
// symmetries of the lattice, so what lies within a piece in one of them does in all.
// Units: lattice units.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::packing::cores {

// The marker with cores instead of pieces that may move, as many as have at least this share of the area of the largest
// piece that they lie in: first of all orientations of one piece, then of several pieces.  Nothing when there are none.
// Without `turns`, pieces keep their orientations.  Nothing, too, when stopped, which is asked for each pair of pieces.
[[nodiscard]] std::optional<Marker> coarsened(const Marker& marker, const std::vector<bool>& moving, bool turns,
                                              double share, const std::stop_token& stop = {});

}  // namespace selvage::packing::cores
