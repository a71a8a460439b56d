// Short translations that separate two overlapping polygons: the proof that a pair keeps its overlap allowance.
//
// The translations t with which q + t does not overlap p are the outside of the Minkowski sum p (+) -q
// [Li94 Theorem 3.1].  The one nearest to a present overlap lies on the sum's boundary: at the foot of the
// perpendicular on one of its edges, or at a corner where it turns inwards.  Every boundary edge is part of a vertex of
// one polygon plus an edge of the other whose direction lies in the vertex's turn (the reduced convolution [BL11]), so
// only those that come near 0 are looked at, and no sum is computed.
//
// A translation that is found is a lattice vector, tested with `overlap`: it is a proof.  The search is not exact in
// the other direction: a pair that only a translation between lattice points would separate may be refused.  At an edge
// that costs at most a lattice unit and a half; at a corner with an acute angle, and where more than kMostCandidates
// edges come near, it may cost more.  Naming the two in the other order only negates the answer.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <optional>

#include "core/geometry/overlap.h"

namespace selvage::geometry {

inline constexpr std::size_t kMostCandidates = 2048;  // translations that are tested, and edges that are intersected

// A lattice vector of length at most `distance` by which q can be moved so that it no longer overlaps p: (0, 0) when
// they do not overlap; nothing when none was found.  REQUIRES: distance >= 0.
[[nodiscard]] std::optional<Vec> separating_translation(const PlacedPolygon& p, const PlacedPolygon& q, Coord distance);

}  // namespace selvage::geometry
