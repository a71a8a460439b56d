// Is a marker valid?  Decided in integers: pieces may touch, never overlap, never be closer than the spacing, never
// leave the strip.  Every answer of Selvage passes through here before it is given.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/geometry/outline.h"
#include "core/marker/marker.h"

namespace selvage {

class SumCache;

// Two pieces that overlap, or are closer than the marker's spacing.
struct Overlap {
  PieceId first, second;  // first < second
  double witness_x{},
      witness_y{};  // a point inside both (between both, when only the spacing is broken); lattice units
  double depth{};   // the shortest move that parts them [Li94 7.1], plus the spacing; lattice units
};
// A piece that leaves the strip.
struct Protrusion {
  PieceId piece;
  Coord by{};  // the largest distance by which it leaves; lattice units
};
struct Validity {
  std::vector<Overlap> overlaps;        // by (first, second)
  std::vector<Protrusion> protrusions;  // by piece
  [[nodiscard]] bool valid() const { return overlaps.empty() && protrusions.empty(); }
};

// A piece as the cache of sums knows it.
[[nodiscard]] OrientedOutline oriented_outline(const Marker& marker, PieceId piece, SumCache& sums);

// The whole answer, with depths (which need Minkowski sums, taken from the cache).
[[nodiscard]] Validity check(const Marker& marker, SumCache& sums);
// Only yes or no.
[[nodiscard]] bool is_valid(const Marker& marker);

}  // namespace selvage
