// A marker prepared for motions: what every scene of it starts from, and what has been proved about it, computed once
// for all calls on the same revision.
#pragma once

#include <vector>

#include "core/marker/figures.h"
#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"
#include "core/model/ties.h"
#include "core/scene/run.h"

namespace selvage::scene {

struct LaidOut {
  LaidOut(const Marker& marker, SumCache& sums);
  LaidOut(const Marker& marker, const Run& run);  // reported as outlines_of says

  marker::PlacedPieces pieces;
  std::vector<outline::OrientedOutline> outlines;
  std::vector<outline::OrientedOutline> parts;  // by piece, as parts_of says
  model::Ties ties;
  marker::Figures figures;
};

// The outline of every piece, as the cache of Minkowski sums knows it.
[[nodiscard]] std::vector<outline::OrientedOutline> outlines_of(const Marker& marker, SumCache& sums);
// The same, reported as stage kDecomposition; kOther begins after it.
[[nodiscard]] std::vector<outline::OrientedOutline> outlines_of(const Marker& marker, const Run& run);
// The part of every piece that has one (core/marker/rules.h); empty when none has.
[[nodiscard]] std::vector<outline::OrientedOutline> parts_of(const Marker& marker, SumCache& sums);

// The figures of the marker after a motion.  If the marker was valid before, pairs of which neither piece changed are
// not proved again.
// REQUIRES: `laid_out` is that of `before`.
[[nodiscard]] marker::Figures figures_after(const Marker& before, const LaidOut& laid_out, const Marker& after);

}  // namespace selvage::scene
