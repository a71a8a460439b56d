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

// The cheapest position of a piece on a grid about its present one, within `reach` on each axis and inside the strip as
// long as `length`.  Deterministic.  REQUIRES: the piece fits there.
[[nodiscard]] Leap cheapest_leap(const scene::Scene& scene, std::uint32_t piece, double reach, Coord length,
                                 const OverlapPrices& prices);

}  // namespace selvage::motion::separation
