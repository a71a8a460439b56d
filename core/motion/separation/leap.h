// A leap: moves one piece that linear programs cannot free to a position where it overlaps less.
#pragma once

#include <map>

#include "core/scene/scene.h"

namespace selvage::motion::separation {

// The price of a unit of overlap; higher for pairs that earlier rounds could not separate.
struct OverlapPrices {
  double usual{};
  std::map<marker::PiecePair, double> raised;
  [[nodiscard]] double of(marker::PiecePair pair) const {
    const auto found = raised.find(pair);
    return found == raised.end() ? usual : found->second;
  }
};

struct Leap {
  Vec to;
  double cost{};  // the sum of price times depth over the overlaps at `to`, plus the length |x| + |y| of the leap
};

// The positions that a leap chooses from: a square grid about the piece's present position.  On an axis on which a
// piece is matched to the cloth's pattern, or to other pieces, the grid's steps are whole repeats, at least one.
struct LeapGrid {
  double reach{};  // lattice units, on each axis
  int steps{};     // from the present position to either side
  Coord length{};  // the piece stays in a strip of this length
};

// The cheapest position of a piece on the grid.  Deterministic.  REQUIRES: the piece fits into the strip.
[[nodiscard]] Leap cheapest_leap(const scene::Scene& scene, PieceId piece, const LeapGrid& grid,
                                 const OverlapPrices& prices);

}  // namespace selvage::motion::separation
