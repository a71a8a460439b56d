// The Minkowski sum of two star-shaped polygons, computed as a polar envelope [Li94 3.4.3, Theorems 3.14 and 3.15].
//
// The sum is star-shaped about the sum of two kernel points.  Its boundary is the outer envelope, seen from that
// centre, of the candidate edges: a convex vertex of one polygon plus an edge of the other whose direction lies in the
// vertex's turn (the reduced convolution [BL11]).  Candidates form chains that turn about the centre, so the envelope
// is computed by merging chains.  Two convex polygons give a single chain, the merge of their edges [Li94 3.4.1].
// Units: lattice units.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/minkowski/convolution/turns.h"
#include "core/outline/star.h"

namespace selvage::minkowski::convolution {

// The origin of an edge of a sum: a vertex of one polygon and an edge (identified by its first vertex) of the other, as
// indices into the whole polygons.
struct EdgeSource {
  std::uint32_t vertex{}, edge{};
  bool vertex_of_first{};
  friend bool operator==(const EdgeSource&, const EdgeSource&) = default;
};

// A boundary edge of a sum, with the sum's interior on its left.
struct SumEdge {
  Vec from, to;            // its end points, rounded to the lattice
  Vec line_from, line_to;  // two lattice points on its exact line: the end points of the whole candidate edge
  EdgeSource source;
  bool inner{};  // known to lie inside the sum of the whole polygons, because of a cut or because no turn of theirs
                 // contains its direction
};

// The sum of two star-shaped parts: edges in counter-clockwise order about the centre.  Each edge starts where the
// previous one ends, up to rounding.
struct StarSum {
  RealVec centre;
  std::vector<SumEdge> edges;
};

// { a + b : a in first, b in second }; nothing when `stopped`, which is asked once for 32 vertices and for each pass
// over all chains, unless it is empty.  REQUIRES: each part's kernel point lies inside its kernel.
[[nodiscard]] std::optional<StarSum> star_sum(const TurningPart& first, const TurningPart& second,
                                              const std::function<bool()>& stopped);

}  // namespace selvage::minkowski::convolution
