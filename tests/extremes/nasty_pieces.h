// Pieces that no pattern maker draws: slivers, spikes, combs, spirals, edges of a unit, edges all but parallel.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/polygon.h"

namespace selvage::test {

struct NastyPiece {
  std::string name;
  Polygon outline;
  double compacts_to{};  // after / before of some of them, rounded up a little
  bool stacked{};        // too long for two beside each other within the lattice
  bool many_parts{};     // hundreds of star parts: a sum of two takes minutes
  bool sum_judged{};     // few enough vertices for CGAL's Minkowski sums
};
[[nodiscard]] std::vector<NastyPiece> nasty_pieces();
// Those of them whose sums CGAL judges.
[[nodiscard]] std::vector<NastyPiece> pieces_with_judged_sums();

// Its kernel is about one lattice unit across, its arms are as long as `arm`.
[[nodiscard]] Polygon pinwheel(Coord arm);

}  // namespace selvage::test
