// The rings of two pieces that keep a spacing: those of their Minkowski sum, grown by a polygon inside the circle whose
// radius is the spacing [Li94 7.5].  The grown rings are contained in the region that the spacing forbids, so what is
// proved with them holds; they leave out at most a hundredth of the spacing, at corners.
// Units: lattice units.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/minkowski/cache.h"
#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::bodies {

// The rings that the position of q relative to p must stay outside of, moved by `offset`; nothing when cancelled.
[[nodiscard]] std::optional<std::vector<cells::WedgeRing>> spaced_rings(const outline::OrientedOutline& p,
                                                                        const outline::OrientedOutline& q,
                                                                        Coord spacing, Vec offset, SumCache& sums,
                                                                        const std::stop_token& stop);

}  // namespace selvage::packing::bodies
