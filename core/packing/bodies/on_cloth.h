// Unplaced pieces in a search: they follow the placed pieces of a marker as pieces of their own.
//
// Locks of x and y and groups say nothing about pieces that have no position, so the search does not see those of
// unplaced pieces; the answer has them again.  A tilt lock keeps its meaning: the piece stays in its orientation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/id.h"
#include "core/marker/marker.h"

namespace selvage::packing::bodies {

// Names a piece of a search: below the number of placed pieces a placed one, then the unplaced ones in their order.
[[nodiscard]] inline PieceId unplaced_piece(const Marker& marker, std::size_t number) {
  return {static_cast<std::uint32_t>(marker.pieces.size() + number)};
}

// The marker of a search and the names of the wanted pieces in it.
struct OnCloth {
  Marker marker;                // the wanted ones of the unplaced pieces follow the placed ones, at the origin
  std::vector<PieceId> wanted;  // as given, but unplaced ones by their place in `marker.pieces`
};
// Every pair of pieces keeps `clearance` more than its spacing, and no two may overlap.  REQUIRES: the clearance is
// even.
[[nodiscard]] OnCloth on_cloth(const Marker& start, std::span<const PieceId> wanted, Coord clearance = 0);

// Pieces from this one on that no position allows as they are turned, because of a nap, a fold or a width, take the
// first orientation of their shape in which some does: a listed one, or a quarter turn of a shape that turns freely.
// Those whose tilt is locked, and those that may lie in none, stay as they are.
void turn_to_lie(Marker& marker, std::size_t from);

// True when some pair of the marker's pieces, placed or not, may overlap.
[[nodiscard]] bool allows_overlaps(const Marker& marker);

// The layout of such a marker with the spacing and the overlap allowances, and its pieces with the locks, groups and
// buffers, of `start`.
// REQUIRES: the ids of the pieces are those of `start`, and in their order.
[[nodiscard]] Marker as_in(const Marker& start, Marker layout);

}  // namespace selvage::packing::bodies
