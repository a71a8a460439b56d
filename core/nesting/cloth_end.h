// What nesting does where the cloth ends: pieces that reach beyond the end are taken off, those of them that still fit
// somewhere are put there, and the rest of the budget is spent on choosing the pieces that lie on the cloth (filling).
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/marker.h"
#include "core/nesting/budget.h"
#include "core/nesting/filling/fill.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/tuning.h"
#include "core/scene/run.h"

namespace selvage::nesting {

// The state of a search on cloth that may end.
struct AtClothEnd {
  const layout::PieceSet& set;
  const std::vector<double>& values;  // by piece
  const NestTuning& tuning;
  const Budget& budget;
  std::uint64_t moves{};  // that are used up already
  std::uint64_t seed{};
};

// `all` has all pieces as placed ones; they are valid, except that pieces other than fixed ones may reach beyond the
// end of the cloth.  When cancelled or out of time, those pieces are left over.
[[nodiscard]] filling::Filling end_with_cloth(Marker all, const AtClothEnd& at, const scene::Run& run);

}  // namespace selvage::nesting
