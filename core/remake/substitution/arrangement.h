// An arrangement: the slots that a new order can take over from a stored marker, or from two of them, one behind the
// other [Li94 10: concatenated markers are longer, and longer markers are better].
// Units: lattice units of the order's resolution.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/matching/label.h"
#include "core/matching/pairing.h"

namespace selvage::remake::substitution {

struct Arrangement {
  std::vector<std::size_t> stored;    // the markers that it comes from, one or two, from left to right
  std::vector<matching::Slot> slots;  // of their placed pieces
  Coord length{};
  double area{};  // of the pieces that lie there; square lattice units
};

// Of the placed pieces of a stored marker, with their labels.  Nothing when it has none, or would be too large for the
// order's lattice.
[[nodiscard]] std::optional<Arrangement> arrangement_of(const matching::LabelledMarker& stored, std::size_t number,
                                                        Resolution resolution);
// The second behind the first.  Nothing when that would be too long for the lattice.
[[nodiscard]] std::optional<Arrangement> concatenated(const Arrangement& first, const Arrangement& second);

}  // namespace selvage::remake::substitution
