// What every motion of a marker works on: its pieces where they lie now, their outlines, and which may move.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"

namespace selvage {

struct Scene {
  Scene(const Marker& start, SumCache& sum_cache);

  [[nodiscard]] bool fixed(std::size_t piece) const;
  // The obstacle that the pair's first piece is to its second.
  [[nodiscard]] Obstacle obstacle(PiecePair pair) const {
    return sums.obstacle(outlines[pair.first], outlines[pair.second]);
  }
  [[nodiscard]] Vec relative_position(PiecePair pair) const { return pieces.at(pair.second) - pieces.at(pair.first); }
  // The marker with the pieces where they are now.
  [[nodiscard]] Marker result() const;

  const Marker& marker;
  SumCache& sums;
  PlacedPieces pieces;
  std::vector<OrientedOutline> outlines;
  std::vector<std::uint32_t> group;  // PositionModel::kFixed for locked pieces, else the piece itself
};

}  // namespace selvage
