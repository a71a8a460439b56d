// Which piece of an order takes the place of which piece of another marker, and in which orientation.
//
// The pairs are those of the least sum of costs (fits.h, assignment.h).  A pair that has more difference than `kUnlike`
// times its area is no pair: its slot stays empty, and its piece is left over.
// Units: lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/marker/marker.h"
#include "core/matching/fits.h"

namespace selvage::matching {

inline constexpr double kUnlike = 0.8;  // of the mean of the two areas

struct Pair {
  std::size_t slot{};
  Orientation orientation;
};
struct Pairing {
  std::vector<std::optional<Pair>> pairs;  // by piece of the order: first the placed ones, then the unplaced ones
  double difference{};                     // the sum of the estimated differences, of pieces and slots without partner
                                           // their areas; square lattice units
};
// Deterministic.  A marker's own pieces are paired with themselves, or with pieces that are equal, at difference 0.
[[nodiscard]] Pairing pair_pieces(const Marker& order, std::span<const Slot> slots);

}  // namespace selvage::matching
