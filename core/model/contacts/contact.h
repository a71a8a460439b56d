// Whether a row stands for a contact: a half-plane is bounded by the whole line of an edge, but the pieces meet only
// where the edge itself is.  A row that holds a piece where no edge is, or at a corner where the half-plane of the
// other edge would let it pass, is an effect of the choice of the free region [Li94 4.1.2, 8.1], not of the pieces.
// Units: lattice units.
#pragma once

#include "core/model/pair_rows.h"

namespace selvage::model::contacts {

enum class Backing {
  kEdge,    // the pieces touch along the row: they cannot move against it
  kCorner,  // they touch where the boundary turns away: behind the corner there is room
  kNone,    // they do not touch there
};

// What is behind a row of the pair, which lies at `position`.  `tolerance`: the pieces touch when they are this close,
// the spacing aside.
[[nodiscard]] Backing backing_of(const PairRow& row, const PairPosition& position, double tolerance);

}  // namespace selvage::model::contacts
