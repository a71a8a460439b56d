// Which piece of an order takes the place of which piece of another marker, and in which orientation.
//
// A slot is the place of a piece in a marker that is to be taken over.  The cost of a piece in a slot is the estimated
// area in which their silhouettes differ, in the best of the orientations that the piece's shape allows, and the growth
// across the strip counts again: pieces stacked across the cloth that become taller do not fit its width any more,
// whereas smaller ones leave a gap (docs/from-the-library.md).  Shapes with the same id are preferred a little.  The
// pairs are those of the least sum of costs (assignment.h).  A pair that has more difference than `kUnlike` times its
// area is no pair: its slot stays empty, and its piece is left over.
// Units: lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::matching {

struct Slot {
  std::string shape;        // its id
  Polygon outline;          // in its orientation, at position 0
  Orientation orientation;  // of the piece that lies there
  Vec at;                   // of the outline
};

// The orientations in which a piece of the shape is tried in a slot: all that the shape allows, without tilt and with
// the slot's own where it allows that.  A shape that may turn freely tries the slot's rotation and quarter turns.
[[nodiscard]] std::vector<Orientation> orientations_of(const Shape& shape, const Orientation& slot);

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

// What a piece of a shape costs in a slot in one of its orientations; square lattice units.
struct Fit {
  double cost{}, difference{};
  Orientation orientation;
};
// One for each of its orientations, the cheapest first.
[[nodiscard]] std::vector<Fit> fits_of(const Shape& shape, const Slot& slot);

}  // namespace selvage::matching
