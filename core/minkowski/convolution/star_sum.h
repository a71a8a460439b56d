// The Minkowski sum of two star-shaped polygons, by its polar envelope [Li94 3.4.3, Theorems 3.14 and 3.15].
//
// The sum is star-shaped about the sum of two kernel points.  Its boundary is the outer envelope, seen from there, of
// the candidate edges: a convex vertex of one polygon plus an edge of the other whose direction lies in the vertex's
// turn (the reduced convolution [BL11]).  Candidates follow each other in chains that turn about the centre, so the
// envelope is a merge of chains; two convex polygons give a single chain, which is the merge of their edges
// [Li94 3.4.1].
#pragma once

#include <cstdint>
#include <vector>

#include "core/outline/star.h"

namespace selvage::minkowski::convolution {

// What made an edge of a sum: a vertex of one polygon and an edge (named by its first vertex) of the other, as indices
// into the whole polygons.
struct EdgeSource {
  std::uint32_t vertex{}, edge{};
  bool vertex_of_first{};
  friend bool operator==(const EdgeSource&, const EdgeSource&) = default;
};

// A boundary edge of a sum, the sum's interior on its left.
struct SumEdge {
  Vec from, to;            // its ends, rounded to the lattice
  Vec line_from, line_to;  // two lattice points of its exact line: the whole candidate edge
  EdgeSource source;
  bool inner{};  // known to lie inside the sum of the whole polygons: made by a cut or by no turn of theirs
};

// The sum of two star-shaped parts: edges in counter-clockwise order about the centre, each beginning where the one
// before ends, up to rounding.
struct StarSum {
  RealVec centre;
  std::vector<SumEdge> edges;
};

// { a + b : a in first, b in second }.  REQUIRES: kernel points inside the parts' kernels.
[[nodiscard]] StarSum star_sum(const outline::StarPart& first, const outline::StarPart& second);

}  // namespace selvage::minkowski::convolution
