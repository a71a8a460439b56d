// The candidate edges of a star-shaped sum, linked into chains [BL11].
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/minkowski/convolution/star_sum.h"
#include "core/minkowski/convolution/turns.h"

namespace selvage::minkowski::convolution {

inline constexpr std::uint32_t kNoCandidate = UINT32_MAX;

// A vertex of one part plus an edge of the other.  Candidates turn counter-clockwise about the sum's centre.
struct Candidate {
  Vec from, to;                                   // end points, exact, in the frame of the sum
  double ax{}, ay{}, bx{}, by{};                  // the end points relative to the centre
  std::uint32_t first_vertex{}, second_vertex{};  // the vertices of the two parts whose sum is `from`
  std::uint32_t next{kNoCandidate};               // the candidate that starts where this one ends
  bool has_previous{};
  bool edge_of_first{};  // whether the edge belongs to the first part
};

// All candidates that turn counter-clockwise about first.kernel + second.kernel; nothing when `stopped`, which is asked
// once for 32 vertices unless it is empty.
[[nodiscard]] std::optional<std::vector<Candidate>> reduced_convolution(const TurningPart& first,
                                                                        const TurningPart& second,
                                                                        const std::function<bool()>& stopped);

// True when a vertex of one part plus an edge of the other (from its vertex `edge` in direction `along`) is known to
// lie inside the sum of the whole polygons: the edge is a cut between parts, or its direction is not within the whole
// polygon's turn at the vertex.
[[nodiscard]] bool inside_whole(const outline::StarPart& of_vertex, std::size_t vertex,
                                const outline::StarPart& of_edge, std::size_t edge, Vec along);

}  // namespace selvage::minkowski::convolution
