// Lattice points in narrow places.  A piece between two that nearly touch it may have less than a unit of room across,
// and much along them: most lattice points beside a given one are then not free, but one farther along is.
// Units: lattice units.
#pragma once

#include <optional>
#include <span>

#include "core/packing/cells/wedge_ring.h"

namespace selvage::packing::bodies {

// A lattice point in the box and in all half-planes, at most some thousand units away from `from`: of all of them the
// nearest along x or along y.  Points beyond a half-plane by less than rounding count as in it.  Nothing when there is
// none.
[[nodiscard]] std::optional<RealVec> lattice_point_near(RealVec from, std::span<const cells::HalfPlane> planes,
                                                        const RealBox& box);

}  // namespace selvage::packing::bodies
