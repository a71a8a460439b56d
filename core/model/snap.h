// Rounds displacements to the lattice so that rows along the axes and the strip's edges still hold.
//
// Every displacement d becomes floor(d + t), with one t for each axis: two pieces whose displacements differ by at
// least a whole number of units still do afterwards, so that rows along the axes and the strip's edges need no margin.
// The values that a solver returns are slightly off: t is therefore the middle of the widest gap between the fractions
// that occur, away from all of them.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/model/position_model.h"

namespace selvage::model {

[[nodiscard]] std::vector<Vec> snapped(std::span<const RealVec> displacements);

}  // namespace selvage::model
