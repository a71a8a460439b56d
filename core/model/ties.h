// Ties: who moves with whom.  On each axis, pieces of one number share their displacement; kFixed ones have none.
// Locks, rigid groups and, within a round, pieces that rounding may not part are all told this way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::model {

struct Ties {
  static constexpr std::uint32_t kFixed = UINT32_MAX;
  std::vector<std::uint32_t> x, y;  // by piece: kFixed, or a number below the number of pieces

  // No motion can move it.
  [[nodiscard]] bool fixed(std::size_t piece) const { return x[piece] == kFixed && y[piece] == kFixed; }
  // The two never move against each other.
  [[nodiscard]] bool joined(std::size_t p, std::size_t q) const { return x[p] == x[q] && y[p] == y[q]; }
  // Free on both axes, and of itself alone.
  [[nodiscard]] bool free(std::size_t piece) const;
  // From now on the two, and all tied to either, move as one.
  void join(std::size_t p, std::size_t q);
};

// A piece locked on an axis is fixed there, and with it its group.
[[nodiscard]] Ties ties_of(const Marker& marker);

}  // namespace selvage::model
