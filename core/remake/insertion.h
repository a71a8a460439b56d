// Insertion: unplaced pieces are put into a valid marker, the largest first, each at the free position that is nearest
// to where it belongs, or at the end of the marker where nothing is free.
// Units: lattice units.
#pragma once

#include <map>
#include <string>

#include "core/marker/marker.h"
#include "core/scene/run.h"

namespace selvage::remake {

// Where pieces belong, by their ids; others go as far left as they can.
using Homes = std::map<std::string, Piece>;

// Puts all unplaced pieces down, each in the allowed orientation that needs the shortest marker and, of these, the
// shortest way.  Returns how many were put within the length that the marker had; pieces for which there is no position
// at all, or that were left when cancelled, stay unplaced. REQUIRES: the placed pieces are valid.  Law: the placed
// pieces stay where they are, and the marker stays valid.
[[nodiscard]] std::size_t insert_unplaced(Marker& marker, const Homes& homes, const scene::Run& run);

}  // namespace selvage::remake
