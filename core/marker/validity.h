// The validity of a marker, decided in integers: pieces may touch, but they must not overlap by more than their
// allowance, be closer than the spacing and their buffers allow, leave the strip or enter its margins, or break one of
// cloth's rules (rules.h).  Every marker that Selvage returns has been checked here.  Units: lattice units.
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

// Two pieces that overlap by more than their allowance, or are closer than their spacing.
struct Overlap {
  PieceId first, second;  // first < second
  double witness_x{},
      witness_y{};  // a point inside both, or midway between them when only the spacing is violated; lattice units
  double depth{};   // the shortest translation that separates them [Li94 7.1] plus the spacing, or less the allowance;
                    // 0 when not measured; lattice units
};
// A piece that extends beyond the strip, into its margins, or out of the room that its rules leave.
struct Protrusion {
  PieceId piece;
  Coord by{};  // the largest distance by which it extends beyond the limit; lattice units
};
// Pieces of one shade that are too far from each other.
struct ShadeFault {
  PieceId leftmost, rightmost;  // of the shade's pieces, by their ends
  Coord by{};                   // lattice units
};
// A piece whose match point is off the phase of another one of its match set.
struct MatchFault {
  PieceId piece, other;
  Vec by;  // lattice units
};
struct Validity {
  std::vector<Overlap> overlaps;        // by (first, second); at most 500,000 of them
  std::vector<Protrusion> protrusions;  // by piece
  std::vector<ShadeFault> shades;       // by the name of the shade
  std::vector<MatchFault> matches;      // by the name of the match set, and by piece
  [[nodiscard]] bool valid() const {
    return overlaps.empty() && protrusions.empty() && shades.empty() && matches.empty();
  }
};

// A piece's outline from the cache, with the symmetry under which it is placed.
[[nodiscard]] outline::OrientedOutline oriented_outline(const Marker& marker, PieceId piece, minkowski::SumCache& sums);
// The same for its part.  REQUIRES: it has one.
[[nodiscard]] outline::OrientedOutline oriented_part(const Piece& piece, minkowski::SumCache& sums);

// All overlaps and protrusions, with depths.  The depths need Minkowski sums, which are taken from the cache.
[[nodiscard]] Validity check(const Marker& marker, minkowski::SumCache& sums);
// The same with cancellation.  Errors: kStoppedEarly.
[[nodiscard]] Result<Validity> check(const Marker& marker, minkowski::SumCache& sums, const std::stop_token& stop);
// All overlapping pairs, or kMostConflicts of them (clearance.h), found exactly but without the costly depths: every
// depth is 0, and the witness is the centre of the intersection of the two boxes.
[[nodiscard]] std::vector<Overlap> overlaps_unmeasured(const Marker& marker);
// Pieces that must stay where they are have to lie validly.  `fixed`: at least for every placed piece, whether it is
// one of them.
// Errors: kMarkerOverlaps and kOutsideStrip when they do not; `field` is a JSON pointer into the marker.
[[nodiscard]] std::optional<Error> defect_of_fixed(const Marker& marker, const std::vector<bool>& fixed);
// The verdict only.
[[nodiscard]] bool is_valid(const Marker& marker);

}  // namespace selvage::marker
