// The tuning constants of the motions of one piece.  They decide how far these motions look and how hard they try; what
// they find is proved whatever the values are.
#pragma once

#include <cstddef>

namespace selvage::motion::piece {

struct BumpTuning {
  int steps{400};            // cells that one bump may pass through
  double first_reach{0.02};  // part of the width: how far the first cell looks
  // A bump across free space looks farther and farther.  When it meets something while it has more than this many
  // pieces in view, it looks only that far again: every cell takes time for each of them.
  std::size_t many_neighbours{24};
  std::size_t ways{40};  // directions around corners that are tried before a bump ends
  double contact{4};     // lattice units: nearer sides count as touched
  double least_gain{2};  // lattice units: smaller gains are rounding
};

struct RelaxTuning {
  int cells{24};            // free regions chosen, each about a better position than the one before
  double reach{0.02};       // part of the width: how far one cell looks
  double nearly_all{0.99};  // part of the reach: a square of this size needs a larger cell
  double least_gain{1e-3};  // part of the freedom: a cell that gains less was the local optimum
  double contact{1};        // lattice units: less freedom counts as none
};

}  // namespace selvage::motion::piece
