// A lower bound on how far several pieces can move to the left together, found without Minkowski sums.  Lines along the
// strip divide it into slabs; in each slab, a piece counts as the box around the part of it that lies there.
// Units: lattice units.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/marker/placed_pieces.h"

namespace selvage::motion::closing {

class Slabs {
 public:
  Slabs(const marker::PlacedPieces& pieces, Coord width);

  // The pieces for which `moving` is true can move at least this far before they come too near to another piece; 0 or
  // less when that is not known.  The strip's end and cloth's rules are not considered.  `box`: around the pieces.
  [[nodiscard]] Coord free_distance(const std::vector<bool>& moving, const Box& box) const;
  // Moves the pieces to the left.
  // REQUIRES: `by` is at most their free distance, so that the spans stay in order.
  void move(const std::vector<bool>& moving, const Box& box, Coord by);

 private:
  static constexpr std::size_t kSlabs = 64;
  // The stretch of a slab that a piece takes, from left to right.
  struct Span {
    Coord from{}, to{};
    std::uint32_t piece{};
    friend auto operator<=>(const Span&, const Span&) = default;
  };

  // The first and the last slab that a box reaches, with the distance that pieces keep.
  [[nodiscard]] std::pair<std::size_t, std::size_t> range(const Box& box) const;
  void add(std::size_t slab, std::uint32_t piece, const geometry::PlacedPolygon& polygon);

  Coord spacing_, height_;
  std::array<std::vector<Span>, kSlabs> spans_;  // by their left ends
};

}  // namespace selvage::motion::closing
