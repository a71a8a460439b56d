// The sections of a long marker: stretches of it that can be shortened apart from each other.
//
// Cuts across the strip divide the marker.  The pieces that a cut meets, and those that lie just right of it, are its
// layer: they keep their places relative to each other.  The pieces between two layers are a section.  To a section,
// the layer on its left is fixed, and the one on its right moves along the strip as one body, together with everything
// behind it.  So the pieces of two sections never come near each other, and what the sections gain adds up.
// Units: lattice units.
#pragma once

#include <cstdint>
#include <vector>

#include "core/marker/placed_pieces.h"

namespace selvage::motion::sections {

using Pieces = std::vector<std::uint32_t>;  // ascending

struct Section {
  Pieces free;         // the pieces that move
  Pieces left, right;  // the layers beside it; empty at the marker's ends
  Coord from{};        // the x right of which the section's pieces stay, as long as the left layer does not move
};

struct Cutting {
  std::size_t pieces{};  // of a section, about
  double offset{};       // 0..1: where the first cut lies, in sections
  Coord layer{};         // the thickness of a layer
};

// The sections from left to right.  No piece belongs to two of them or to two layers: where pieces are long, there are
// fewer cuts.
[[nodiscard]] std::vector<Section> sections_of(const marker::PlacedPieces& pieces, const Cutting& cutting);

}  // namespace selvage::motion::sections
