// Silhouettes: outlines as 1,024 bits, compared by counting the bits that differ.  They rank thousands of pairs of
// shapes; the few that matter are then compared by their true areas (alignment.h).
//
// The grid has 32 by 32 cells and is as large as the outline's box, so small pieces are as sharp as large ones.  A bit
// is set when the middle of its cell lies inside.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/polygon.h"

namespace selvage::matching {

struct Silhouette {
  static constexpr int kSide = 32;
  std::array<std::uint32_t, kSide> rows{};  // from the bottom; the lowest bit is leftmost
  double width{}, height{};                 // of the box; lattice units
  double area{};                            // of the outline; square lattice units
  std::uint64_t
      hash{};  // of the outline with its box at the origin, from its smallest vertex: equal for equal outlines
};
[[nodiscard]] Silhouette silhouette_of(const Polygon& outline);

// An estimate of the area in which the two outlines differ when the middles of their boxes coincide; square lattice
// units.
// Laws.  (1) Symmetric.  (2) 0 for outlines that are translates of each other, and above 0 for others, but for a
// collision of their hashes.
[[nodiscard]] double estimated_difference(const Silhouette& first, const Silhouette& second);

}  // namespace selvage::matching
