// The candidate edges of a star sum, linked into chains.
#pragma once

#include <cstdint>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"

namespace selvage::minkowski::convolution {

inline constexpr std::uint32_t kNoCandidate = UINT32_MAX;

// A vertex of one part plus an edge of the other, placed relative to the sum's centre; turns counter-clockwise about
// it.
struct Candidate {
  Vec from, to;                                   // exact, in the frame of the sum
  double ax{}, ay{}, bx{}, by{};                  // the same, relative to the centre
  std::uint32_t first_vertex{}, second_vertex{};  // of the parts: what `from` is the sum of
  std::uint32_t next{kNoCandidate};               // the candidate that begins where this one ends
  bool has_previous{};
  bool edge_of_first{};  // the edge is the first part's
};

// All candidates that turn counter-clockwise about first.kernel + second.kernel.
[[nodiscard]] std::vector<Candidate> reduced_convolution(const outline::StarPart& first,
                                                         const outline::StarPart& second);

// True when a vertex of one part plus an edge of the other, which leaves its vertex `edge` along `along`, lies inside
// the sum of the whole polygons: the edge is a cut, or its direction is not in the whole polygon's turn at the vertex.
[[nodiscard]] bool inside_whole(const outline::StarPart& of_vertex, std::size_t vertex,
                                const outline::StarPart& of_edge, std::size_t edge, Vec along);

}  // namespace selvage::minkowski::convolution
