// Layouts in which pieces overlap as far as their allowances let them.  The exact searches look only at layouts without
// overlaps; here a compaction and a short nesting, which use the allowances, look for others.  They prove nothing about
// layouts that they do not find.
// Units: lattice units.  Laws: the pieces that were moved lie validly, proved in integers; the same input gives the
// same answer, unless it is stopped.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/marker/marker.h"
#include "core/outline/enclosed/container.h"
#include "core/scene/run.h"

namespace selvage::packing {

// Whether a nesting chooses among the same orientations of the piece as an exact search: all that its shape lists,
// without a tilt.
[[nodiscard]] bool nests_as_searched(const Marker& marker, const Piece& piece, bool turns);

struct OverlapSettings {
  bool turns{true};               // pieces may take other orientations that their shapes allow
  std::uint64_t moves_a_piece{};  // of the nesting; 0: there is none
};

// The marker with all of its pieces placed, compacted and nested; nothing when it is not shorter, unless pieces were
// unplaced before.  The input may overlap.
[[nodiscard]] std::optional<Marker> packed_with_overlaps(const Marker& start, const OverlapSettings& settings,
                                                         const scene::Run& run);

// The marker with the wanted pieces in the container; the others stay.  Nothing when no layout is found, and when a
// wanted piece belongs to a group or keeps an orientation that a nesting would change.  REQUIRES: `wanted` names pieces
// of the marker.  Where these lie does not matter, except that locked ones stay.
[[nodiscard]] std::optional<Marker> contained_with_overlaps(const Marker& start, std::span<const PieceId> wanted,
                                                            const outline::enclosed::Container& container,
                                                            const OverlapSettings& settings, const scene::Run& run);

}  // namespace selvage::packing
