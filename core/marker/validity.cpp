#include "core/marker/validity.h"

#include <algorithm>

#include "core/geometry/outline.h"
#include "core/marker/placed_pieces.h"
#include "core/minkowski/cache.h"
#include "core/minkowski/nearest_edges.h"

namespace selvage {

Coord protrusion_of(const Box& box, const Strip& strip) {
  const Box room = strip.room(strip.last().value_or(box.high.x));
  return std::max({room.low.x - box.low.x, room.low.y - box.low.y, box.high.x - room.high.x, box.high.y - room.high.y});
}

OrientedOutline oriented_outline(const Marker& marker, PieceId id, SumCache& sums) {
  const Piece& piece = marker.pieces[id.value];
  const SplitOrientation parts = split(piece.orientation);
  return {sums.outline(turned(marker.shapes[piece.shape.value].outline, parts.turn)), parts.symmetry};
}

Validity check(const Marker& marker, SumCache& sums) {
  Validity validity;
  const PlacedPieces pieces{marker};
  for (const PiecePair& pair : conflicts(pieces)) {
    const auto [first, second] = pair;
    const PlacedPolygon p = pieces[first];
    const PlacedPolygon q = pieces[second];
    const auto inside_both = common_point(p, q);
    const Witness witness = inside_both ? *inside_both : nearest_point(p, q);
    const Obstacle obstacle =
        sums.obstacle(oriented_outline(marker, PieceId{first}, sums), oriented_outline(marker, PieceId{second}, sums));
    const double distance = nearest_boundary_point(obstacle.sum(), obstacle.to_frame(q.at - p.at)).distance;
    const double depth = static_cast<double>(pieces.spacing(pair)) + (inside_both ? distance : -distance);
    validity.overlaps.push_back({PieceId{first}, PieceId{second}, witness.x, witness.y, depth});
  }
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (const Coord by = protrusion_of(pieces.box(i), marker.strip); by > 0) {
      validity.protrusions.push_back({PieceId{i}, by});
    }
  }
  return validity;
}

bool is_valid(const Marker& marker) {
  return is_valid(PlacedPieces{marker}, marker.strip);
}

bool is_valid(const PlacedPieces& pieces, const Strip& strip) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (protrusion_of(pieces.box(i), strip) > 0) return false;
  }
  return conflicts(pieces).empty();
}

}  // namespace selvage
