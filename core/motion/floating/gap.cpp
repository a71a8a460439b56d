#include "core/motion/floating/gap.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance.h"
#include "core/geometry/separating_translation.h"

namespace selvage::motion::floating {
namespace {

Box room_on(const Strip& strip, const marker::PlacedPieces& pieces, std::uint32_t piece) {
  return pieces.room(piece, strip, strip.last().value_or(kLatticeLimit));
}

Coord width_to_edge(StripEdge edge, const Box& piece, const Box& room) {
  switch (edge) {
    case StripEdge::kLeft: return piece.low.x - room.low.x;
    case StripEdge::kRight: return room.high.x - piece.high.x;
    case StripEdge::kBottom: return piece.low.y - room.low.y;
    case StripEdge::kTop: break;
  }
  return room.high.y - piece.high.y;
}

bool fills(const Box& piece, const Box& room, StripEdge edge) {
  const bool along = edge == StripEdge::kLeft || edge == StripEdge::kRight;
  return along ? piece.width() == room.width() : piece.height() == room.height();
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

std::vector<Gap> gaps_within(const scene::Scene& scene, Coord reach, const Strip& strip, bool edges) {
  std::vector<Gap> gaps;
  for (const auto& [p, q] : pairs_within(scene.pieces, reach)) {
    if (!scene.ties.joined(p, q)) gaps.push_back({PieceId{p}, PieceId{q}});
  }
  for (std::uint32_t i = 0; edges && i < scene.pieces.size(); ++i) {
    if (scene.fixed(i)) continue;
    const Box box = scene.pieces.box(i);
    const Box room = room_on(strip, scene.pieces, i);
    for (const StripEdge edge : {StripEdge::kLeft, StripEdge::kRight, StripEdge::kBottom, StripEdge::kTop}) {
      if (!fills(box, room, edge) && width_to_edge(edge, box, room) < reach) gaps.push_back({PieceId{i}, edge});
    }
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

double width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Strip& strip, double reach) {
  if (const PieceId* other = other_piece(gap)) {
    if (const Coord overlap = overlap_of(pieces, pair_of(gap)); overlap > 0) return -static_cast<double>(overlap);
    return distance_within(pieces.facing(gap.piece.value, other->value), pieces.facing(other->value, gap.piece.value),
                           reach);
  }
  const Coord width = width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value),
                                    room_on(strip, pieces, gap.piece.value));
  return std::min(reach, static_cast<double>(width));
}

Coord whole_width_within(const Gap& gap, const marker::PlacedPieces& pieces, const Strip& strip, Coord reach) {
  if (const PieceId* other = other_piece(gap)) {
    if (const Coord overlap = overlap_of(pieces, pair_of(gap)); overlap > 0) return -overlap;
    return whole_distance_within(pieces.facing(gap.piece.value, other->value),
                                 pieces.facing(other->value, gap.piece.value), reach);
  }
  return std::min(reach, width_to_edge(std::get<StripEdge>(gap.opposite), pieces.box(gap.piece.value),
                                       room_on(strip, pieces, gap.piece.value)));
}

}  // namespace selvage::motion::floating
