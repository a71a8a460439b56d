// Gaps between two pieces, or between a piece and an edge of the strip, and their widths.
#pragma once

#include <compare>
#include <variant>
#include <vector>

#include "core/base/id.h"
#include "core/scene/scene.h"
#include "core/scene/strip_edge.h"

namespace selvage::motion::floating {

// Between a piece and a later one, or between a piece and an edge of the strip.
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

// All gaps that may be narrower than `reach`, sorted: between pieces whose boxes are closer than that on both axes and,
// if `edges`, to the edges of their rooms on `strip`.  Gaps that no motion can change are left out: between
// pieces that are fixed or move together, and between an edge and a piece that is fixed or fills its room.
[[nodiscard]] std::vector<Gap> gaps_within(const scene::Scene& scene, Coord reach, const Strip& strip, bool edges);

// The width of a gap, at most `reach`; lattice units.  For pieces that overlap as they may, the length of a translation
// that separates them, in whole units and negated; otherwise 0 for pieces that overlap, negative for a piece beyond the
// edge.
[[nodiscard]] double width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Strip& strip, double reach);
// The same in whole units, rounded down exactly.
[[nodiscard]] Coord whole_width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Strip& strip,
                                       Coord reach);

}  // namespace selvage::motion::floating
