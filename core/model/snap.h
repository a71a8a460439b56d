// Rounds displacements to the lattice without breaking what holds exactly.
//
// Every displacement d becomes floor(d + t), with one t for each axis: two pieces whose displacements differ by at
// least a whole number of units still do, so rows along the axes and the strip's edges need no margin.  Solvers return
// values off by a little: t is put in the middle of the widest gap between the fractions that occur, away from every
// edge.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/model/position_model.h"

namespace selvage::model {

[[nodiscard]] std::vector<Vec> snapped(std::span<const RealVec> displacements);

}  // namespace selvage::model
