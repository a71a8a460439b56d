#include "core/packing/bodies/range_by_rules.h"

#include "core/marker/clearance.h"

namespace selvage::packing::bodies {

std::optional<Box> range_by_rules(const Marker& marker, const marker::PlacedPieces& placed, const Freedom& freedom,
                                  std::uint32_t piece, const Box& own) {
  const Piece& lying = marker.pieces[piece];
  if (!may_lie(marker, lying)) return std::nullopt;
  const marker::Rules& rules = lying.rules;
  const Polygon outline = oriented(marker.shapes[lying.shape.value].outline, lying.orientation);
  const Coord end = marker.strip.last().value_or(kLatticeLimit);
  const Box room = room_for(rules, own.height(), fold_edge(rules, outline, marker.strip), marker.strip, end);
  Strip plain = marker.strip;
  plain.repeat = {};  // a matched piece may also change to another repeat
  const Box among = placed.room_among(piece, freedom.moving, plain, end);  // along x as in any orientation
  const Coord along = freedom.clearance;
  const Coord across = rules.on_fold ? 0 : along;
  return Box{{among.low.x + along - own.low.x, room.low.y + across - own.low.y},
             {among.high.x - along - own.high.x, room.high.y - across - own.high.y}};
}

}  // namespace selvage::packing::bodies
