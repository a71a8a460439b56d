#include "core/packing/bodies/on_cloth.h"

#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/marker/clearance.h"

namespace selvage::packing::bodies {

OnCloth on_cloth(const Marker& start, std::span<const PieceId> wanted, Coord clearance) {
  const std::size_t placed = start.pieces.size();
  std::vector<bool> moves(start.unplaced.size());
  for (const PieceId id : wanted) {
    if (id.value >= placed) moves[id.value - placed] = true;
  }
  OnCloth result{start, {}};
  result.marker.unplaced.clear();
  std::vector<std::uint32_t> place(start.unplaced.size());
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (!moves[k]) {
      result.marker.unplaced.push_back(start.unplaced[k]);
      continue;
    }
    place[k] = static_cast<std::uint32_t>(result.marker.pieces.size());
    Piece piece = start.unplaced[k];
    piece.group.clear();
    piece.locked.x = piece.locked.y = false;
    result.marker.pieces.push_back(std::move(piece));
  }
  result.marker.spacing += clearance;
  result.marker.overlap = 0;
  for (Piece& piece : result.marker.pieces) {
    piece.buffer += clearance / 2;
    piece.overlap.reset();
  }
  for (const PieceId id : wanted) {
    result.wanted.push_back(id.value < placed ? id : PieceId{place[id.value - placed]});
  }
  return result;
}

void turn_to_lie(Marker& marker, std::size_t from) {
  for (std::size_t k = from; k < marker.pieces.size(); ++k) {
    Piece& piece = marker.pieces[k];
    const Shape& shape = marker.shapes[piece.shape.value];
    const std::vector<Angle> quarters{{0}, {90}, {180}, {270}};
    const Orientation given = piece.orientation;
    bool lies = piece.locked.tilt || marker::may_lie(marker, piece);
    for (const bool flip : {false, true}) {
      for (const Angle rotation : shape.rotations.empty() ? quarters : shape.rotations) {
        if (lies || (flip && !shape.may_flip)) continue;
        piece.orientation = {flip, rotation, given.tilt};
        lies = marker::may_lie(marker, piece);
      }
    }
    if (!lies) piece.orientation = given;
  }
}

bool allows_overlaps(const Marker& marker) {
  if (marker.spacing > 0) return false;
  std::size_t pieces = 0;
  for (const auto* list : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *list) pieces += piece.buffer == 0 && piece.overlap.value_or(marker.overlap) > 0 ? 1 : 0;
  }
  return pieces > 1;
}

Marker as_in(const Marker& start, Marker layout) {
  std::unordered_map<std::string_view, const Piece*> unplaced;
  for (const Piece& piece : start.unplaced) unplaced.emplace(piece.id, &piece);
  layout.spacing = start.spacing;
  layout.overlap = start.overlap;
  for (std::size_t k = 0; k < layout.pieces.size(); ++k) {
    Piece& piece = layout.pieces[k];
    const Piece& was = k < start.pieces.size() ? start.pieces[k] : *unplaced.at(piece.id);
    piece.group = was.group;
    piece.locked = was.locked;
    piece.buffer = was.buffer;
    piece.overlap = was.overlap;
  }
  return layout;
}

}  // namespace selvage::packing::bodies
