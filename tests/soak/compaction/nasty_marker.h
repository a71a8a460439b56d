// Loose markers that are hard for a compaction: shapes with corners, teeth, slots and mouths, laid out with gaps and
// with exact contacts, under every kind of constraint.
#pragma once

#include "core/marker/marker.h"
#include "tests/support/random.h"

namespace selvage::test {

inline constexpr std::uint32_t kUsualPieces = 16;

// A valid marker of 2 to `most_pieces` pieces of up to four shapes: triangles, rectangles, diamonds, stars, combs,
// gears, C-shapes, slots, keyholes and bars that fit a slot exactly; in columns of pieces that have gaps between them,
// touch, or meet corner to corner; with spacing, buffers, margins, locks, groups, tilts and rotations by odd angles in
// some. Units: 10^6 lattice units in a millimetre, and a strip up to a metre wide; wider for more pieces.
[[nodiscard]] Marker nasty_marker(Random& random, std::uint32_t most_pieces = kUsualPieces);

}  // namespace selvage::test
