#include "core/marker/clearance.h"

#include <algorithm>

#include "core/geometry/separating_translation.h"

namespace selvage::marker {
namespace {

constexpr std::size_t kBlock = 512;           // pairs that one thread proves at a time
constexpr std::size_t kAtOnce = 64 * kBlock;  // pairs that are found before they are proved
// Up to this many changed pieces are compared with all others one by one; the pairs of more are found by a sweep.
constexpr std::size_t kFew = 16;

// True when the polygon, in place of the piece, collides with none of the others but for those that skip(other) names.
template <class Skip>
bool clear_of_others(const PlacedPieces& pieces, std::uint32_t piece, const geometry::PlacedPolygon& polygon,
                     std::span<const Vec> part, const Skip& skip) {
  const Box near = polygon.placed_box().grown(pieces.widest_spacing());
  for (std::uint32_t other = 0; other < pieces.size(); ++other) {
    if (other == piece || !near.overlaps(pieces.box(other)) || skip(other)) continue;
    if (pieces.may_share_cloth(piece, other)) continue;
    const bool whole = !pieces.shows_part(piece, other);
    const geometry::PlacedPolygon own{whole ? polygon.vertices : part, polygon.box, polygon.at};
    if (collide(own, pieces.facing(other, piece), pieces.spacing({piece, other}))) return false;
  }
  return true;
}

}  // namespace

bool collide(const geometry::PlacedPolygon& p, const geometry::PlacedPolygon& q, Coord spacing) {
  if (spacing > 0) return closer_than(p, q, spacing);
  return spacing == 0 ? overlap(p, q) : !separating_translation(p, q, -spacing);
}

bool conflict(const PlacedPieces& pieces, PiecePair pair) {
  const auto [p, q] = pair;
  return collide(pieces.facing(p, q), pieces.facing(q, p), pieces.spacing(pair));
}

std::vector<PiecePair> conflicts(const PlacedPieces& pieces, const Executor& executor, const std::stop_token& stop) {
  std::vector<PiecePair> found;
  std::vector<PiecePair> near;  // that are not proved yet
  const auto prove = [&] {
    const auto proved = gathered<PiecePair>(executor, near.size(), kBlock, [&](std::size_t k, auto& out) {
      if (!stop.stop_requested() && conflict(pieces, near[k])) out.push_back(near[k]);
    });
    found.insert(found.end(), proved.begin(), proved.end());
    near.clear();
    return stop.stop_requested() || found.size() >= kMostConflicts;
  };
  const bool all = !any_pair_within(pieces, pieces.widest_spacing(), [&](PiecePair pair) {
    near.push_back(pair);
    return near.size() == kAtOnce && prove();
  });
  if (all) prove();
  found.resize(std::min(found.size(), kMostConflicts));
  std::sort(found.begin(), found.end());
  return found;
}

bool any_conflict(const PlacedPieces& pieces) {
  return any_pair_within(pieces, pieces.widest_spacing(), [&](PiecePair pair) { return conflict(pieces, pair); });
}

bool is_clear(const PlacedPieces& pieces, std::uint32_t piece, const geometry::PlacedPolygon& polygon,
              std::span<const Vec> part) {
  return clear_of_others(pieces, piece, polygon, part, [](std::uint32_t) { return false; });
}

bool are_clear(const PlacedPieces& pieces, const std::vector<bool>& moving, Vec by) {
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
    if (!moving[piece]) continue;
    geometry::PlacedPolygon polygon = pieces[piece];
    polygon.at = polygon.at + by;
    const auto moves = [&](std::uint32_t other) { return moving[other]; };
    if (!clear_of_others(pieces, piece, polygon, pieces.part(piece), moves)) return false;
  }
  return true;
}

bool are_clear(const PlacedPieces& pieces, std::span<const std::uint32_t> changed) {
  if (changed.size() <= kFew) {
    return std::all_of(changed.begin(), changed.end(),
                       [&](std::uint32_t piece) { return is_clear(pieces, piece, pieces[piece], pieces.part(piece)); });
  }
  std::vector<bool> is_changed(pieces.size());
  for (const std::uint32_t piece : changed) is_changed[piece] = true;
  return !any_pair_within(pieces, pieces.widest_spacing(), [&](PiecePair pair) {
    return (is_changed[pair.first] || is_changed[pair.second]) && conflict(pieces, pair);
  });
}

Coord protrusion_of(const PlacedPieces& pieces, std::size_t piece, const Strip& strip) {
  const Box box = pieces.box(piece);
  const Box room = pieces.room(piece, strip, strip.last().value_or(kLatticeLimit));
  return std::max({room.low.x - box.low.x, room.low.y - box.low.y, box.high.x - room.high.x, box.high.y - room.high.y});
}

bool keep_joint_rules(const PlacedPieces& pieces) {
  const auto shades = pieces.shades();
  const auto sets = pieces.match_sets();
  return std::all_of(shades.begin(), shades.end(), [&](const Shade& shade) { return pieces.excess_of(shade) <= 0; }) &&
         std::all_of(sets.begin(), sets.end(), [&](const MatchSet& set) { return pieces.off_phase(set) == 0; });
}

bool shares_shade(const Marker& marker, const Piece& piece) {
  if (!marker.shade || piece.rules.shade.empty()) return false;
  const auto other = [&piece](const Piece& one) { return one.rules.shade == piece.rules.shade && one.id != piece.id; };
  return std::any_of(marker.pieces.begin(), marker.pieces.end(), other) ||
         std::any_of(marker.unplaced.begin(), marker.unplaced.end(), other);
}

bool may_lie(const Marker& marker, const Piece& piece) {
  const Rules& rules = piece.rules;
  const Strip& strip = marker.strip;
  const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
  const Box box = box_of(outline);
  const Box room =
      room_for(rules, box.height(), fold_edge(rules, outline, strip), strip, strip.last().value_or(kLatticeLimit));
  const bool in_band = (!rules.from && !rules.to) || box.width() <= room.width();
  if (box.height() > room.height() || !in_band) return false;
  if (marker.shade && box.width() > *marker.shade && shares_shade(marker, piece)) return false;
  if (rules.matched_to_cloth()) {
    const Box matched = matched_room(room, box, turned_match(piece), repeat_for(rules, strip));
    if (matched.height() < box.height() || matched.width() < box.width()) return false;
  }
  return keeps_nap(rules, piece.orientation) && has_side_for_fold(rules, outline, strip);
}

bool are_inside(const PlacedPieces& pieces, const Strip& strip) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (protrusion_of(pieces, i, strip) > 0) return false;
  }
  return keep_joint_rules(pieces);
}

bool all_clear(const PlacedPieces& pieces, const Strip& strip) {
  return are_inside(pieces, strip) && !any_conflict(pieces);
}

}  // namespace selvage::marker
