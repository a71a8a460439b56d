// Where cloth's rules (core/marker/rules.h) let a body of a search lie.
// Units: lattice units.
#pragma once

#include <cstdint>
#include <optional>

#include "core/marker/marker.h"
#include "core/marker/placed_pieces.h"
#include "core/packing/bodies/bodies.h"

namespace selvage::packing::bodies {

// The positions of a body that leave one of its pieces in its room, near enough to those of its shade that stay, and
// with the clearance from the room's ends; the fold asks for none.  That a piece is matched to the cloth does not limit
// them.  `own`: the box of the piece when the body is at the origin.  Empty (high < low) when no position does; nothing
// when none can in the orientation that the piece has in `marker`.  `placed`: the pieces where they lie now.
[[nodiscard]] std::optional<Box> range_by_rules(const Marker& marker, const marker::PlacedPieces& placed,
                                                const Freedom& freedom, std::uint32_t piece, const Box& own);

}  // namespace selvage::packing::bodies
