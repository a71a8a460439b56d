// The figures of a marker that are reported after every change: its length, its utilisation and whether it is valid.
// All are computed from a single layout of the pieces.
#pragma once

#include "core/marker/marker.h"
#include "core/marker/placed_pieces.h"

namespace selvage::marker {

struct Figures {
  Coord length{};        // x of the right end of the rightmost piece; lattice units
  double utilisation{};  // 0..1
  bool valid{};          // exact, the same as is_valid for markers of make_marker, whose pieces are turned as their
                         // rules ask
  Wide doubled_area{};   // of the pieces that lie on the cloth; square lattice units
};
[[nodiscard]] Figures figures_of(const Marker& marker);
// The same for a marker whose pieces have been laid out already.
[[nodiscard]] Figures figures_of(const Marker& marker, const PlacedPieces& pieces);
// The same for a marker that was made from a valid one.  Pairs of unchanged pieces need no new proof.
// REQUIRES: `before` is valid; `pieces` is its layout, and `figures` are its figures.
[[nodiscard]] Figures figures_after(const Marker& before, const PlacedPieces& pieces, const Figures& figures,
                                    const Marker& marker);

// The utilisation of a marker whose length is known, 0..1.
[[nodiscard]] double utilisation_at(const Marker& marker, Coord length);

}  // namespace selvage::marker
