// Overlap removal: the overlapping pieces of a substitution become a valid marker.
//
// First by separation, which moves pieces as little as it can [Li94 5.2].  Where columns leave no room for that, pieces
// are popped out and put back (popping.h), first only a few.  Where that fails or makes the marker much longer, a
// guided local search (core/nesting/local_search) also tries in a marker that it lengthens step by step; the shorter
// result counts.  Where the search fails, too, more pieces may be popped.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "core/marker/marker.h"
#include "core/remake/substitution/tuning.h"
#include "core/scene/run.h"

namespace selvage::remake {

using substitution::RemakeTuning;

// What removed the overlaps.
enum class RemovedBy { kNothing, kSeparation, kPopping, kSearch };

// Which of the ways are tried.
enum class Removal {
  kAnyWay,
  kQuick,  // only linear programs, with few pieces popped
};

struct OverlapRemoval {
  Marker marker;         // valid; popped pieces are put back, so all pieces of the substitution are placed
  RemovedBy by{};        // kNothing: there were none
  std::size_t popped{};  // pieces that were popped and put back
  int programs{};        // linear programs solved
};
// Nothing when the pieces did not come apart, or when cancelled before.  Unplaced pieces are left as they are.
// REQUIRES: the strip has no end.  Laws.  (1) The answer is valid, proved in integers.  (2) A marker that is valid is
// left as it is.  (3) Deterministic, whatever the cache holds.
[[nodiscard]] std::optional<OverlapRemoval> remove_overlaps(const Marker& start, const RemakeTuning& tuning,
                                                            const scene::Run& run, Removal removal = Removal::kAnyWay);

}  // namespace selvage::remake
