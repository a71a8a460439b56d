// What the multipliers of rows prove, by weak duality with outward rounding: this is where a search's claims become
// certain.  Any non-negative multipliers give a valid proof, however the program was solved [NS04].
//
// Argument.  Every row r(p) >= 0 holds for all layouts that the node stands for.  So does the sum of multiples of rows,
// S(p) >= 0, and its maximum over the positions' ranges is at least S(p).  If that maximum is negative there is no such
// layout; likewise  length >= min (length - S(p)).  Both are computed in doubles, from n terms of products of two
// factors; the sum of their sizes times 2^-44 is more than all roundings together (at most n + 4 of 2^-53 each, with
// n < 500) and is taken off.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/packing/programs/dictionary.h"

namespace selvage::packing::programs {

// Where the bodies, and the length, can be.
struct Ranges {
  struct Why {
    Reasons low_x{}, low_y{}, high_x{}, high_y{};
  };
  std::vector<RealBox> bodies;
  double low_length{}, high_length{};
  std::vector<Why> why{};           // of the bodies' ranges; empty: they hold unconditionally
  std::span<const RealBox> wide{};  // where the bodies can be, unconditionally; as many as `why`
};

// The rows have no common solution within the ranges.
[[nodiscard]] bool refutes(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges);

// No solution within the ranges has a length below this.
[[nodiscard]] double least_length(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges);

// Why `refutes`, or `least_length` above the ceiling, holds: the reasons of the rows, and of as few ranges as do.
[[nodiscard]] Reasons why_refuted(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges);
[[nodiscard]] Reasons why_longer(std::span<const Dictionary::Multiplier> multipliers, const Ranges& ranges,
                                 double ceiling);

}  // namespace selvage::packing::programs
