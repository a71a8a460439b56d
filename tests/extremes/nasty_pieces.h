// Difficult pieces that no pattern maker would draw: slivers, spikes, combs, spirals, edges one unit long, and nearly
// parallel edges.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::test {

struct NastyPiece {
  std::string name;
  Polygon outline;
  bool stacked{};     // so long that two do not fit side by side within the lattice limit
  bool many_parts{};  // it has hundreds of star-shaped parts, so a sum of two takes minutes
  bool sum_judged{};  // it has few enough vertices for CGAL's Minkowski sums
};
[[nodiscard]] std::vector<NastyPiece> nasty_pieces();
// The pieces whose sums are checked with CGAL.
[[nodiscard]] std::vector<NastyPiece> pieces_with_judged_sums();

// A star whose kernel is about one lattice unit across and whose arms are as long as `arm`.
[[nodiscard]] Polygon pinwheel(Coord arm);

}  // namespace selvage::test
