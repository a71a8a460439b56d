// Unoccupied regions: the connected regions of the cloth that no piece covers, between the strip's edges or margins and
// the two ends of the marker.  Small trim pieces can be placed there [Li94 4.2.2].  Zones with a quality, which some
// pieces may use, are cloth like any other.
//
// Taken literally, nearly all the open cloth of a marker is connected, through gaps too narrow for any piece.  These
// regions therefore keep a clearance from every piece: gaps narrower than twice the clearance separate two regions.
// Units: lattice units, areas in square lattice units.  Corners are rounded (core/outline/set_operations.h), so the
// result must not be used for proofs.
#pragma once

#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/marker/placed_pieces.h"
#include "core/outline/set_operations.h"

namespace selvage::marker {

// With a smaller clearance, rounding would decide whether a gap is open.
inline constexpr Coord kLeastClearance = 2;

struct UnoccupiedSettings {
  double least_area{};  // regions with a smaller area are left out; a fraction of the squared strip width
  Coord clearance{};    // distance of the regions from pieces; at least kLeastClearance is used
};
// Defaults.  For cloth 1.5 m wide: regions of at least 2 cm^2, gaps of at least 6 mm.
[[nodiscard]] UnoccupiedSettings unoccupied_settings(const Strip& strip);

// A piece adjacent to a region.  The vector (x, y) is the region's outward unit normal integrated over the shared
// boundary: the rate at which the region's area grows when the piece moves.
struct Bordering {
  PieceId piece;
  double x{}, y{};
  friend bool operator==(const Bordering&, const Bordering&) = default;
};

struct UnoccupiedRegion {
  outline::Region region;
  double area{};
  std::vector<Bordering> around;  // sorted by piece
  friend bool operator==(const UnoccupiedRegion&, const UnoccupiedRegion&) = default;
};

// The regions from left to right, sorted by the smallest vertices of their outlines (by x, then y).
[[nodiscard]] std::vector<UnoccupiedRegion> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                               const UnoccupiedSettings& settings);
[[nodiscard]] std::vector<UnoccupiedRegion> unoccupied_regions(const Marker& marker,
                                                               const UnoccupiedSettings& settings);
// The same with cancellation.  Errors: kStoppedEarly.  The token is not checked inside left_over
// (core/outline/set_operations.h).
[[nodiscard]] Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const PlacedPieces& pieces, const Strip& strip,
                                                                       const UnoccupiedSettings& settings,
                                                                       const std::stop_token& stop);
[[nodiscard]] Result<std::vector<UnoccupiedRegion>> unoccupied_regions(const Marker& marker,
                                                                       const UnoccupiedSettings& settings,
                                                                       const std::stop_token& stop);

}  // namespace selvage::marker
