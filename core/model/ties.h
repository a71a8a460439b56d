// Ties: which pieces move together.  On each axis, pieces with the same number share one displacement, and pieces
// marked kFixed do not move.  Ties express locks, rigid groups and, within a round, pairs that rounding would make
// collide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/marker/marker.h"
#include "core/marker/placed_pieces.h"

namespace selvage::model {

struct Ties {
  static constexpr std::uint32_t kFixed = UINT32_MAX;
  std::vector<std::uint32_t> x, y;  // by piece: kFixed, or a number below the number of pieces

  // True when no motion can move the piece.
  [[nodiscard]] bool fixed(std::size_t piece) const { return x[piece] == kFixed && y[piece] == kFixed; }
  // True when the two never move against each other.
  [[nodiscard]] bool joined(std::size_t p, std::size_t q) const { return x[p] == x[q] && y[p] == y[q]; }
  // True when the piece is free on both axes and tied to no other.
  [[nodiscard]] bool free(std::size_t piece) const;
  // Ties the two together, with all that is tied to either.
  void join(std::size_t p, std::size_t q);
};

// These ties and those of match sets: where the pattern repeats, the pieces of a set share a displacement, so that they
// stay in phase.  A motion of single pieces does without them, because a single piece may move by whole repeats.
[[nodiscard]] Ties with_match_sets(Ties ties, const marker::PlacedPieces& pieces, const Strip& strip);

// The ties of a marker: a piece that is locked on an axis is fixed there, and so is its group.
[[nodiscard]] Ties ties_of(const Marker& marker);

}  // namespace selvage::model
