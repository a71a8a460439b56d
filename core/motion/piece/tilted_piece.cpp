#include "core/motion/piece/tilted_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/marker/rules.h"
#include "core/model/tilting/tilt_rows.h"

namespace selvage::motion::piece {

RealVec held_pivot(const geometry::PlacedPolygon& piece, Angle turn) {
  const double radians = turn.degrees * (std::numbers::pi / 180);
  const RealVec pivot = model::tilting::pivot_of(piece);
  const double x = pivot.x - static_cast<double>(piece.at.x);
  const double y = pivot.y - static_cast<double>(piece.at.y);
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return {x - (c * x - s * y), y - (s * x + c * y)};
}

TiltRange tilt_range(const Marker& marker, PieceId id) {
  const Piece& piece = marker.pieces[id.value];
  const Angle limit = marker.shapes[piece.shape.value].tilt_limit;
  const Angle now = piece.orientation.tilt;
  const bool matched = piece.rules.match && marker.strip.repeat.any();
  const bool held =
      piece.locked.x || piece.locked.y || piece.locked.tilt || !piece.group.empty() || piece.rules.on_fold || matched;
  if (held) return {now, now};
  return {std::min(now, Angle::of_degrees(-limit.degrees)), std::max(now, limit)};
}

Piece tilted(const Piece& piece, const geometry::PlacedPolygon& from, Angle tilt) {
  const RealVec held = held_pivot(from, Angle::of_degrees(tilt.degrees - piece.orientation.tilt.degrees));
  Piece turned_piece = piece;
  turned_piece.orientation.tilt = tilt;
  turned_piece.at = from.at + Vec{std::llround(held.x), std::llround(held.y)};
  return turned_piece;
}

bool is_cuttable(const Marker& marker, const Piece& piece) {
  const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
  const Coord across = box_of(outline).height();
  const marker::FoldEdge fold = fold_edge(piece.rules, outline, marker.strip);
  return clean_polygon(outline) && part_is_polygon(piece) &&
         across <= room_for(piece.rules, across, fold, marker.strip, kLatticeLimit).height();
}

}  // namespace selvage::motion::piece
