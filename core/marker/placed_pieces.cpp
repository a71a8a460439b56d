#include "core/marker/placed_pieces.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <tuple>

namespace selvage::marker {
namespace {

// Calls visit(pair) for every pair whose boxes are closer than `distance` on both axes, from left to right, until it
// returns true.  Returns whether it did.
template <class Visit>
bool sweep(const PlacedPieces& pieces, Coord distance, const Visit& visit) {
  struct Entry {
    Box box;
    std::uint32_t piece{};
  };
  std::vector<Entry> entries(pieces.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {pieces.box(i), i};
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.box.low.x != b.box.low.x ? a.box.low.x < b.box.low.x : a.piece < b.piece;
  });
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Box reach = entries[k].box.grown(distance);
    for (std::size_t m = k + 1; m < entries.size() && entries[m].box.low.x < reach.high.x; ++m) {
      if (!reach.overlaps(entries[m].box)) continue;
      if (pieces.may_share_cloth(entries[k].piece, entries[m].piece)) continue;
      if (visit(PiecePair{std::minmax(entries[k].piece, entries[m].piece)})) return true;
    }
  }
  return false;
}

}  // namespace

PlacedPieces::PlacedPieces(const Marker& marker) : spacing_{marker.spacing} {
  std::map<std::tuple<ShapeId, Orientation, Polygon>, std::shared_ptr<const SharedPolygon>> made;
  polygons_.reserve(marker.pieces.size());
  at_.reserve(marker.pieces.size());
  for (const Piece& piece : marker.pieces) {
    Polygon part = turned_part(piece);
    auto& polygon = made[{piece.shape, piece.orientation, part}];
    if (!polygon) {
      Polygon vertices = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
      const Box box = box_of(vertices);
      polygon = std::make_shared<const SharedPolygon>(SharedPolygon{std::move(vertices), box, std::move(part)});
    }
    polygons_.push_back(polygon);
    at_.push_back(piece.at);
    buffers_.push_back(piece.buffer);
    overlaps_.push_back(piece.overlap.value_or(marker.overlap));
  }
  const Coord widest_buffer = buffers_.empty() ? 0 : *std::max_element(buffers_.begin(), buffers_.end());
  widest_spacing_ = std::max(spacing_, 2 * widest_buffer);
  if (auto rooms = rooms_of(marker)) rooms_ = std::make_shared<const Rooms>(*std::move(rooms));
  if (!rooms_) return;
  for (const Piece& piece : marker.pieces) matches_.push_back(turned_match(piece));
}

void PlacedPieces::replace(std::size_t piece, Polygon polygon, Vec at, Vec match, Polygon part) {
  if (rooms_) matches_[piece] = match;
  const Box box = box_of(polygon);
  polygons_[piece] = std::make_shared<const SharedPolygon>(SharedPolygon{std::move(polygon), box, std::move(part)});
  at_[piece] = at;
}

void PlacedPieces::move_by(std::span<const Vec> by) {
  for (std::size_t i = 0; i < size(); ++i) at_[i] = at_[i] + by[i];
}

Coord PlacedPieces::length() const {
  Coord length = 0;
  for (std::size_t i = 0; i < size(); ++i) length = std::max(length, end_of(i));
  return length;
}

Box PlacedPieces::room_by_rules(std::size_t piece, const Strip& strip, Coord end) const {
  const Rules& rules = rooms_->rules[piece];
  const Box own = box(piece);
  const Box room = room_for(rules, own.height(), fold_edge(rules, polygons_[piece]->vertices, strip), strip, end);
  return rules.matched_to_cloth() ? matched_room(room, own, match_at(piece), repeat_for(rules, strip)) : room;
}

Box PlacedPieces::room_among(std::size_t piece, const std::vector<bool>& moving, const Strip& strip, Coord end) const {
  Box among = room(piece, strip, end);
  for (const Shade& shade : shades()) {
    if (!std::binary_search(shade.pieces.begin(), shade.pieces.end(), piece)) continue;
    for (const std::uint32_t other : shade.pieces) {
      if (other == piece || moving[other]) continue;
      among.low.x = std::max(among.low.x, box(other).high.x - shade.length);
      among.high.x = std::min(among.high.x, box(other).low.x + shade.length);
    }
  }
  const MatchSet* const set = match_set_of(piece);
  if (set == nullptr) return among;
  const auto stays = [&](std::uint32_t other) { return other != piece && !moving[other]; };
  const auto anchor = std::find_if(set->begin(), set->end(), stays);
  if (anchor == set->end()) return among;
  Repeat repeat = strip.repeat;
  repeat.phase = match_at(*anchor);
  return matched_room(among, box(piece), match_at(piece), repeat);
}

const MatchSet* PlacedPieces::match_set_of(std::size_t piece) const {
  for (const MatchSet& set : match_sets()) {
    if (std::binary_search(set.begin(), set.end(), piece)) return &set;
  }
  return nullptr;
}

Coord PlacedPieces::off_phase(const MatchSet& set) const {
  Coord most = 0;
  for (const std::uint32_t piece : set) {
    const Vec off = off_phase(piece, set.front());
    most = std::max({most, std::abs(off.x), std::abs(off.y)});
  }
  return most;
}

Coord PlacedPieces::excess_of(const Shade& shade) const {
  Coord low = kLatticeLimit;
  Coord high = -kLatticeLimit;
  for (const std::uint32_t piece : shade.pieces) {
    low = std::min(low, box(piece).low.x);
    high = std::max(high, box(piece).high.x);
  }
  return high - low - shade.length;
}

std::vector<PiecePair> pairs_within(const PlacedPieces& pieces, Coord distance) {
  std::vector<PiecePair> pairs;
  sweep(pieces, distance, [&](PiecePair pair) {
    pairs.push_back(pair);
    return false;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool any_pair_within(const PlacedPieces& pieces, Coord distance, const std::function<bool(PiecePair)>& test) {
  return sweep(pieces, distance, test);
}

}  // namespace selvage::marker
