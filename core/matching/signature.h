// Signatures: a marker in a few numbers, by which the nearest of many thousand stored markers are found.
//
// The numbers describe the distribution of the pieces' areas and of the sides of their shapes' boxes, relative to the
// strip's width.  They are the same for one bundle as for six, so that a marker of half the bundles is found as a part
// of a concatenation; the number of pieces and their area are counted separately.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::matching {

struct Signature {
  static constexpr std::size_t kQuantiles = 8;
  std::string unit;
  double width{}, spacing{};  // in the unit
  double pieces{};            // their number, placed or not
  double area{};              // of all of them, in squared widths of the strip
  // Quantiles of the pieces' areas, longer and shorter sides: square roots of areas, all in widths of the strip.
  std::array<float, 3 * kQuantiles> spread{};
  friend bool operator==(const Signature&, const Signature&) = default;
};
// REQUIRES: the marker has pieces.
[[nodiscard]] Signature signature_of(const Marker& marker);

// Which stored markers may be near an order at all: the unit is the same, and width and spacing differ by no
// more than these slacks.
inline constexpr double kWidthSlack = 0.01;     // part of the order's width
inline constexpr double kSpacingSlack = 0.001;  // part of the order's width

// How far a stored marker is from an order; infinite when it cannot be near.  A marker with half the order's pieces is
// as near as a whole one.
// Laws.  (1) 0 for the order's own marker.  (2) Not less than 0.
[[nodiscard]] double distance_between(const Signature& order, const Signature& stored);

// The part of that distance in which the pieces themselves differ, whatever their number and their cloth.
[[nodiscard]] double spread_between(const Signature& a, const Signature& b);

// The indices of the nearest, nearest first, at most `count`; of equals the first.  Leaves out those that cannot be
// near.
[[nodiscard]] std::vector<std::size_t> nearest(const Signature& order, std::span<const Signature> stored,
                                               std::size_t count);

}  // namespace selvage::matching
