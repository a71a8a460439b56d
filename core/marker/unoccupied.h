// Unoccupied regions: the connected parts of the cloth that no piece covers, between the strip's edges, or margins, and
// the marker's two ends: where trim pieces may still go [Li94 4.2.2].
//
// Strictly nearly all open cloth of a marker hangs together, through passages that nothing fits through.  What counts
// here is cloth with some clearance from every piece: passages narrower than twice that part two regions.
// Units: lattice units, areas in square ones.  Corners are rounded (core/geometry/set_operations.h): not for proofs.
#pragma once

#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/marker/placed_pieces.h"
#include "core/outline/set_operations.h"

namespace selvage::marker {

// Passages no wider than rounding would be neither open nor shut.
inline constexpr Coord kLeastClearance = 2;

struct UnoccupiedSettings {
  double least_area{};  // regions smaller than this part of the width squared are left out
  Coord clearance{};    // how far regions stay away from pieces; less than kLeastClearance counts as that
};
// On cloth of 1.5 m: regions of at least 2 cm^2, passages of at least 6 mm.
[[nodiscard]] UnoccupiedSettings unoccupied_settings(const Strip& strip);

// A piece beside a region.  The vector is the region's outward normal times the length, summed along the piece: how
// fast the region's area grows when the piece moves.
struct Bordering {
  PieceId piece;
  double x{}, y{};
  friend bool operator==(const Bordering&, const Bordering&) = default;
};

struct UnoccupiedRegion {
  outline::Region region;
  double area{};
  std::vector<Bordering> around;  // by piece
  friend bool operator==(const UnoccupiedRegion&, const UnoccupiedRegion&) = default;
};

// From left to right: by the outlines' smallest vertices (by x, then y).
[[nodiscard]] std::vector<UnoccupiedRegion> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                               const UnoccupiedSettings& settings);
[[nodiscard]] std::vector<UnoccupiedRegion> unoccupied_regions(const Marker& marker,
                                                               const UnoccupiedSettings& settings);
// The same for whoever may ask to stop.  Errors: kStoppedEarly.  Within left_over (core/geometry/set_operations.h) a
// stop is not heard.
[[nodiscard]] Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                                       const UnoccupiedSettings& settings,
                                                                       const std::stop_token& stop);
[[nodiscard]] Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const Marker& marker,
                                                                       const UnoccupiedSettings& settings,
                                                                       const std::stop_token& stop);

}  // namespace selvage::marker
