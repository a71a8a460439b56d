// A leap: takes one jammed piece out of where linear programs cannot free it, to where it overlaps less.
#pragma once

#include <map>

#include "core/scene/scene.h"

namespace selvage::motion::separation {

// What a unit of overlap costs: of pairs that have withstood, more.
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
  double cost{};  // the sum of price times depth over the overlaps there, plus the leap's length |x| + |y|
};

// The positions that a leap chooses from: a square grid about the piece's present position.
struct LeapGrid {
  double reach{};  // lattice units, on each axis
  int steps{};     // from the present position to either side
  Coord length{};  // the piece stays in a strip of this length
};

// The cheapest position of a piece on the grid.  Deterministic.  REQUIRES: the piece fits into the strip.
[[nodiscard]] Leap cheapest_leap(const scene::Scene& scene, std::uint32_t piece, const LeapGrid& grid,
                                 const OverlapPrices& prices);

}  // namespace selvage::motion::separation
