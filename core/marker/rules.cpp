#include "core/marker/rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "core/marker/marker.h"

namespace selvage::marker {
namespace {

// The multiple of `repeat` that is nearest to `by` between `low` and `high`; nothing when there is none between them.
std::optional<Coord> nearest_multiple(Coord by, Coord repeat, Coord low, Coord high) {
  const auto floored = [repeat](Coord value) {
    const Coord rest = value % repeat;
    return value - (rest < 0 ? rest + repeat : rest);
  };
  const Coord least = floored(low + repeat - 1);
  const Coord most = floored(high);
  if (least > most) return std::nullopt;
  return std::clamp(floored(by + repeat / 2), least, most);
}

// One axis of matched_room.
void match(Coord& room_low, Coord& room_high, Coord low, Coord high, Coord point, Coord repeat, Coord phase) {
  if (repeat <= 0) return;
  const Coord off = point - phase;  // in phase where the piece moves by a multiple of the repeat, less this
  const auto to = nearest_multiple(off, repeat, room_low - low + off, room_high - high + off);
  room_high = to ? high + *to - off : room_low + (high - low) - 1;
  if (to) room_low = low + *to - off;
}

// True when cloth of this class may carry the zone's.
bool accepts(Quality worst, const Rules& zone) {
  return zone.quality && *zone.quality <= worst;
}

}  // namespace

Box matched_room(const Box& room, const Box& box, Vec point, const Repeat& repeat) {
  Box matched = room;
  match(matched.low.x, matched.high.x, box.low.x, box.high.x, point.x, repeat.along, repeat.phase.x);
  match(matched.low.y, matched.high.y, box.low.y, box.high.y, point.y, repeat.across, repeat.phase.y);
  return matched;
}

Vec off_repeat(Vec way, const Repeat& repeat) {
  const auto off = [](Coord along, Coord step) {
    return step <= 0 ? 0 : along - nearest_multiple(along, step, -kLatticeLimit, kLatticeLimit).value_or(0);
  };
  return {off(way.x, repeat.along), off(way.y, repeat.across)};
}

bool keeps_nap(const Rules& rules, const Orientation& orientation) {
  constexpr double kQuarter = 90;
  if (!rules.nap) return true;
  const double from_up = std::abs(std::remainder(orientation.rotation.degrees, 360.0));
  return *rules.nap == Nap::kUp ? from_up < kQuarter : from_up > kQuarter;
}

bool may_share_cloth(const Rules& p, const Rules& q) {
  if (!p.zone && !q.zone) return false;
  if (p.zone && q.zone) return true;
  const Rules& zone = p.zone ? p : q;
  const Rules& piece = p.zone ? q : p;
  return accepts(piece.quality.value_or(0), zone) && (!piece.part || accepts(piece.part->quality, zone));
}

bool only_part_meets(const Rules& piece, const Rules& zone) {
  return zone.zone && piece.part && accepts(piece.quality.value_or(0), zone) && !accepts(piece.part->quality, zone);
}

bool has_side_at(std::span<const Vec> outline, FoldEdge edge) {
  const Box box = box_of(outline);
  const Coord end = edge == FoldEdge::kLower ? box.low.y : box.high.y;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    if (outline[k].y == end && outline[(k + 1) % outline.size()].y == end) return true;
  }
  return false;
}

FoldEdge fold_edge(const Rules& rules, std::span<const Vec> outline, const Strip& strip) {
  const bool either = rules.on_fold && strip.tube;
  return either && !has_side_at(outline, FoldEdge::kLower) ? FoldEdge::kUpper : FoldEdge::kLower;
}

bool has_side_for_fold(const Rules& rules, std::span<const Vec> outline, const Strip& strip) {
  return !rules.on_fold || has_side_at(outline, fold_edge(rules, outline, strip));
}

Repeat repeat_for(const Rules& rules, const Strip& strip) {
  Repeat repeat = strip.repeat;
  repeat.phase = rules.phase.value_or(repeat.phase);
  return repeat;
}

Box room_for(const Rules& rules, Coord height, FoldEdge fold, const Strip& strip, Coord end) {
  if (rules.zone) return {{-kLatticeLimit, -kLatticeLimit}, {kLatticeLimit, kLatticeLimit}};
  Box room = strip.room(end);
  if (rules.below) room.low.y = *rules.below;
  if (rules.above) room.high.y = strip.width - *rules.above;
  if (rules.from) room.low.x = std::max(room.low.x, *rules.from);
  if (rules.to) room.high.x = std::min(room.high.x, *rules.to);
  if (rules.on_fold && fold == FoldEdge::kLower) {
    room.low.y = 0;
    room.high.y = std::min(room.high.y, height);
  }
  if (rules.on_fold && fold == FoldEdge::kUpper) {
    room.high.y = strip.width;
    room.low.y = std::max(room.low.y, strip.width - height);
  }
  return room;
}

std::optional<Rooms> rooms_of(const Marker& marker) {
  const auto ruled = [&marker](const Piece& piece) {
    const Rules& rules = piece.rules;
    return rules.own_room() || (marker.shade && !rules.shade.empty()) || (rules.match && marker.strip.repeat.any());
  };
  if (std::none_of(marker.pieces.begin(), marker.pieces.end(), ruled)) return std::nullopt;
  Rooms rooms;
  rooms.repeat = marker.strip.repeat;
  std::map<std::string_view, std::vector<std::uint32_t>> shades, sets;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const Rules& rules = marker.pieces[i].rules;
    rooms.rules.push_back(rules);
    if (marker.shade && !rules.shade.empty()) shades[rules.shade].push_back(i);
    if (rooms.repeat.any() && rules.match && !rules.match_set.empty()) sets[rules.match_set].push_back(i);
  }
  std::set<std::string_view> unplaced;  // shades of pieces that do not lie on the cloth
  for (const Piece& piece : marker.unplaced) unplaced.insert(piece.rules.shade);
  for (auto& [name, pieces] : shades) {
    if (pieces.size() > 1 || unplaced.contains(name)) rooms.shades.push_back({std::move(pieces), *marker.shade});
  }
  for (auto& [name, pieces] : sets) {
    if (pieces.size() > 1) rooms.match_sets.push_back(std::move(pieces));
  }
  return rooms;
}

}  // namespace selvage::marker
