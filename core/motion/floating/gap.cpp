#include "core/motion/floating/gap.h"

#include <algorithm>

#include "core/geometry/distance.h"

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
  if (const PieceId* other = other_piece(gap))
    return distance_within(pieces[gap.piece.value], pieces[other->value], reach);
  const Coord width = width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value), strip);
  return std::min(reach, static_cast<double>(width));
}

Coord whole_width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Box& strip, Coord reach) {
  if (const PieceId* other = other_piece(gap)) {
    return whole_distance_within(pieces[gap.piece.value], pieces[other->value], reach);
  }
  return std::min(reach, width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value), strip));
}

}  // namespace selvage::motion::floating
