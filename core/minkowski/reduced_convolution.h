// The candidate edges of a star sum, linked into chains.
#pragma once

#include <cstdint>
#include <vector>

#include "core/minkowski/star_sum.h"

namespace selvage {

inline constexpr std::uint32_t kNoCandidate = UINT32_MAX;

// A vertex of one part plus an edge of the other, placed relative to the sum's centre; turns counter-clockwise about it.
struct Candidate {
  Vec from, to;                  // exact, in the frame of the sum
  double ax{}, ay{}, bx{}, by{}; // the same, relative to the centre
  std::uint32_t first_vertex{}, second_vertex{};  // of the parts: what `from` is the sum of
  std::uint32_t next{kNoCandidate};               // the candidate that begins where this one ends
  bool has_previous{};
  bool edge_of_first{};          // the edge is the first part's
};

// All candidates that turn counter-clockwise about first.kernel + second.kernel.
[[nodiscard]] std::vector<Candidate> reduced_convolution(const StarPart& first, const StarPart& second);

}  // namespace selvage
