// A marker laid out: what every scene of it begins with and what is proved of it, worked out once for all calls that
// work on the same revision.
#pragma once

#include <vector>

#include "core/marker/figures.h"
#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"
#include "core/model/ties.h"

namespace selvage::scene {

struct LaidOut {
  LaidOut(const Marker& marker, SumCache& sums);

  marker::PlacedPieces pieces;
  std::vector<outline::OrientedOutline> outlines;
  model::Ties ties;
  marker::Figures figures;
};

// A marker's outlines, one to a piece, as the cache of sums knows them.
[[nodiscard]] std::vector<outline::OrientedOutline> outlines_of(const Marker& marker, SumCache& sums);

// The figures of what a motion made of a marker.  When that was valid, nothing is proved again of two pieces that are
// as they were.
// REQUIRES: `laid_out` is of `before`.
[[nodiscard]] marker::Figures figures_after(const Marker& before, const LaidOut& laid_out, const Marker& after);

}  // namespace selvage::scene
