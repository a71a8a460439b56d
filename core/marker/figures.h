// What is told of a marker after every change: how long it is, how much of the cloth it uses, and whether it is valid,
// from laying its pieces out once.
#pragma once

#include "core/marker/marker.h"
#include "core/marker/placed_pieces.h"

namespace selvage::marker {

struct Figures {
  Coord length{};        // where the rightmost piece ends; lattice units
  double utilisation{};  // 0..1
  bool valid{};          // decided in integers, as by is_valid
};
[[nodiscard]] Figures figures_of(const Marker& marker);
// The same, of a marker whose pieces are laid out already.
[[nodiscard]] Figures figures_of(const Marker& marker, const PlacedPieces& pieces);
// The same of a marker that comes from a valid one: of two pieces that are as they were nothing needs to be proved
// again. REQUIRES: `before` is valid, and `pieces` are its own.
[[nodiscard]] Figures figures_after(const Marker& before, const PlacedPieces& pieces, const Marker& marker);

// The utilisation of a marker whose length is known.
[[nodiscard]] double utilisation_at(const Marker& marker, Coord length);

}  // namespace selvage::marker
