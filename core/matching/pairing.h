// Which piece of an order takes the place of which piece of another marker, and in which orientation.
//
// The pairs have the least sum of costs (assignment.h): for how the shapes fit (fits.h) and for what the pieces are
// called (label.h).  Where one of two pieces has no name, the ids of their shapes are compared instead, and shapes with
// the same id are preferred a little.  Two that differ by more than `kUnlike` times their area are not paired: the slot
// stays empty, and the piece is left over.
// Units: lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/marker/marker.h"
#include "core/matching/fits.h"
#include "core/matching/label.h"

namespace selvage::matching {

inline constexpr double kUnlike = 0.8;  // of the mean of the two areas

struct Pair {
  std::size_t slot{};
  Orientation orientation;
};
struct Pairing {
  std::vector<std::optional<Pair>> pairs;  // by piece of the order: first the placed ones, then the unplaced ones
  double difference{};  // the sum of the estimated differences, and of the areas of pieces and slots without a partner;
                        // square lattice units
};
// Laws.  (1) Deterministic.  (2) A marker's own pieces are paired with themselves, or with pieces that are equal, names
// and sizes included, at difference 0.  (3) Labels raise the sum of the fits' costs by at most the sum of their prices.
// When cancelled, the pairing may be empty: a caller that may be cancelled looks at the token afterwards.
[[nodiscard]] Pairing pair_pieces(const LabelledMarker& order, std::span<const Slot> slots, const LabelPrices& prices,
                                  const std::stop_token& stop = {});

}  // namespace selvage::matching
