// Gaps: what lies between a piece and another, or between a piece and an edge of the strip, and how wide it is.
#pragma once

#include <compare>
#include <variant>
#include <vector>

#include "core/base/id.h"
#include "core/scene/scene.h"

namespace selvage::motion::floating {

enum class StripEdge { kLeft, kRight, kBottom, kTop };

// Between a piece and a later one, or an edge of the strip.
struct Gap {
  PieceId piece;
  std::variant<PieceId, StripEdge> opposite;
  friend auto operator<=>(const Gap&, const Gap&) = default;
};

// The pair of pieces, or nullptr for an edge.
[[nodiscard]] inline const PieceId* other_piece(const Gap& gap) {
  return std::get_if<PieceId>(&gap.opposite);
}
[[nodiscard]] inline marker::PiecePair pair_of(const Gap& gap) {
  return {gap.piece.value, std::get<PieceId>(gap.opposite).value};
}

// All gaps that may be narrower than `reach`, sorted: between pieces whose boxes come closer than that on both axes,
// and, if `edges`, to the edges of `strip`.  Gaps that no motion can change are left
// out: between pieces that are fixed or move as one, between a fixed piece and an edge.
[[nodiscard]] std::vector<Gap> gaps_within(const scene::Scene& scene, Coord reach, const Box& strip, bool edges);

// How wide a gap is, but at most `reach`; lattice units.  0 for pieces that overlap, negative for a piece beyond the
// edge.
[[nodiscard]] double width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Box& strip, double reach);
// The same in whole units, rounded down exactly.
[[nodiscard]] Coord whole_width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Box& strip,
                                       Coord reach);

}  // namespace selvage::motion::floating
