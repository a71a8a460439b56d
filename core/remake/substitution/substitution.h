// Substitution: the pieces of an order are put where those of a stored marker lie, whether they overlap there or not
// [Li94 5.3].
//
// A piece takes the orientation and the alignment in which it differs least from what lay there; of orientations that
// differ about as little, the one in which it overlaps its neighbours least.  Then pieces of columns that have become
// too tall for the strip (columns.h) change places with smaller pieces that are like them.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <vector>

#include "core/marker/marker.h"
#include "core/remake/substitution/choice.h"
#include "core/scene/run.h"

namespace selvage::remake::substitution {

struct Substitution {
  Marker marker;        // may overlap; pieces without a slot are unplaced
  std::size_t swaps{};  // made to relieve columns
  double excess{};      // what columns still reach beyond the strip, summed
};

// The marker's strip is that of the order, without an end.  Deterministic.
[[nodiscard]] Substitution substituted(const Marker& order, const Candidate& candidate, const RemakeTuning& tuning,
                                       const scene::Run& run);

// The marker with the middle of every piece moved away from x = 0 by this factor; unchanged by factors up to 1.
[[nodiscard]] Marker stretched(Marker marker, double factor);

}  // namespace selvage::remake::substitution
