// Popping: pieces that keep the others from coming apart are taken out and put back [Li94 10].
//
// Separation takes out the pieces whose rows of the linear program have the greatest dual values: the tightest
// constraints are theirs (SeparationSettings::pop_out).  Trims go first.  They return one by one, the largest first:
//     where there is room for the piece as it is, nearest to where it belongs; or
//     where there is room for it when it is shrunken: there it is restored to its size and the overlaps are removed by
//     separation; copies that are less and less large are tried; or
//     at the end of the marker.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <optional>

#include "core/marker/marker.h"
#include "core/remake/substitution/tuning.h"
#include "core/scene/run.h"

namespace selvage::remake {

struct Popping {
  Marker marker;         // valid; all placed pieces of the input are placed, in the input's sequence
  std::size_t popped{};  // pieces that were taken out and put back; 0: separation alone was enough
  int programs{};        // linear programs solved
};
// Nothing when more than `most` pieces would have to be taken out, when one of them fits nowhere, or when cancelled
// before.
// REQUIRES: the strip has no end, and no piece is unplaced.  Laws.  (1) The answer is valid, proved in integers.
// (2) Deterministic, whatever the cache holds.
[[nodiscard]] std::optional<Popping> apart_by_popping(const Marker& start, std::size_t most,
                                                      const substitution::RemakeTuning& tuning, const scene::Run& run);

}  // namespace selvage::remake
