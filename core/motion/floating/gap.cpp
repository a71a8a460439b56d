#include "core/motion/floating/gap.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance.h"
#include "core/geometry/separating_translation.h"

namespace selvage::motion::floating {
namespace {

Coord width_to_edge(StripEdge edge, const Box& piece, const Box& strip) {
  switch (edge) {
    case StripEdge::kLeft: return piece.low.x - strip.low.x;
    case StripEdge::kRight: return strip.high.x - piece.high.x;
    case StripEdge::kBottom: return piece.low.y - strip.low.y;
    case StripEdge::kTop: break;
  }
  return strip.high.y - piece.high.y;
}

// The length, in whole units rounded up, of a short translation that separates two pieces that overlap as they may; 0
// when they do not overlap.
Coord overlap_of(const marker::PlacedPieces& pieces, marker::PiecePair pair) {
  const Coord spacing = pieces.spacing(pair);
  if (spacing >= 0) return 0;
  const auto by = separating_translation(pieces[pair.first], pieces[pair.second], -spacing);
  if (!by) return -spacing;
  auto length = static_cast<Coord>(std::sqrt(static_cast<double>(dot(*by, *by))));
  while (static_cast<Wide>(length) * length < dot(*by, *by)) ++length;
  return length;
}

}  // namespace

std::vector<Gap> gaps_within(const scene::Scene& scene, Coord reach, const Box& strip, bool edges) {
  std::vector<Gap> gaps;
  for (const auto& [p, q] : pairs_within(scene.pieces, reach)) {
    if (!scene.ties.joined(p, q)) gaps.push_back({PieceId{p}, PieceId{q}});
  }
  for (std::uint32_t i = 0; edges && i < scene.pieces.size(); ++i) {
    if (scene.fixed(i)) continue;
    for (const StripEdge edge : {StripEdge::kLeft, StripEdge::kRight, StripEdge::kBottom, StripEdge::kTop}) {
      if (width_to_edge(edge, scene.pieces.box(i), strip) < reach) gaps.push_back({PieceId{i}, edge});
    }
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

double width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Box& strip, double reach) {
  if (const PieceId* other = other_piece(gap)) {
    if (const Coord overlap = overlap_of(pieces, pair_of(gap)); overlap > 0) return -static_cast<double>(overlap);
    return distance_within(pieces[gap.piece.value], pieces[other->value], reach);
  }
  const Coord width = width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value), strip);
  return std::min(reach, static_cast<double>(width));
}

Coord whole_width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Box& strip, Coord reach) {
  if (const PieceId* other = other_piece(gap)) {
    if (const Coord overlap = overlap_of(pieces, pair_of(gap)); overlap > 0) return -overlap;
    return whole_distance_within(pieces[gap.piece.value], pieces[other->value], reach);
  }
  return std::min(reach, width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value), strip));
}

}  // namespace selvage::motion::floating
