// Whether a few markers are enough, decided by listing their sets.
//
// A relaxation pays for small parts of many markers and lays, a cutting for whole ones.  The more markers every cutting
// is known to have, the better the bound (CuttingProgram).  So all sets of 1, 2, ... candidates are listed, as far as
// the work allows, and it is decided exactly whether the markers of a set deliver the order, and what they cost at
// least.
//
// Method.  Colour by colour, a marker's ratio times its units, summed over the set, must lie in the box of what may be
// delivered.  All markers of a set but the last are eliminated by projecting onto two directions perpendicular to their
// ratios: in the projection, the ray of the last ratio must meet the box of every colour.  Two colours rarely have such
// a ray in common, and then all sets of these markers and another one are excluded at once.  The few sets that remain
// are decided by trying all units, within bounds.
// Units: as in cutting.h.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/lp/linear_program.h"
#include "core/planning/program/cutting.h"

namespace selvage::planning::program {

struct FewMarkers {
  int fewest{1};                     // about every cutting of fewer markers, this is known:
  double least{lp::kInfinity};       // it costs this much at least; infinite when none of them delivers the order
  std::optional<Cutting> cutting{};  // the cheapest of them that was seen
};

struct SetLimits {
  std::uint64_t work{};  // how many sets may be looked at, about; what exceeds it is not begun, or does not count
  double target{-lp::kInfinity};  // of the bound: once sets of some number cost less, those of more are not listed
};

// Deterministic, unless it is stopped.  REQUIRES: no ratio occurs twice.
[[nodiscard]] FewMarkers few_markers(const orders::Problem& problem, const std::vector<Candidate>& candidates,
                                     const SetLimits& limits, std::stop_token stop = {});

}  // namespace selvage::planning::program
