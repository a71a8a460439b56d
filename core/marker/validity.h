// Is a marker valid?  Decided in integers: pieces may touch, never overlap, never be closer than the spacing and
// their buffers allow, never leave the strip or enter its margins.  Every answer of Selvage passes through here before
// it is given.
#pragma once

#include <optional>
#include <stop_token>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/outline/outline.h"

namespace selvage::minkowski {
class SumCache;
}

namespace selvage::marker {

// Two pieces that overlap, or are closer than their spacing.
struct Overlap {
  PieceId first, second;  // first < second
  double witness_x{},
      witness_y{};  // a point inside both (between both, when only the spacing is broken); lattice units
  double depth{};   // the shortest move that parts them [Li94 7.1], plus the spacing; 0: not measured; lattice units
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
[[nodiscard]] outline::OrientedOutline oriented_outline(const Marker& marker, PieceId piece, minkowski::SumCache& sums);

// The whole answer, with depths (which need Minkowski sums, taken from the cache).
[[nodiscard]] Validity check(const Marker& marker, minkowski::SumCache& sums);
// The same for whoever may ask to stop.  Errors: kStoppedEarly.
[[nodiscard]] Result<Validity> check(const Marker& marker, minkowski::SumCache& sums, const std::stop_token& stop);
// All that overlap, found exactly but not measured, which is what takes long: depths are 0, and a witness is the middle
// of what the two boxes share.
[[nodiscard]] std::vector<Overlap> overlaps_unmeasured(const Marker& marker);
// Only yes or no.
[[nodiscard]] bool is_valid(const Marker& marker);

}  // namespace selvage::marker
