#include "core/marker/rules.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "core/marker/marker.h"

namespace selvage::marker {

Box room_for(const Rules& rules, Coord height, const Strip& strip, Coord end) {
  Box room = strip.room(end);
  if (rules.below) room.low.y = *rules.below;
  if (rules.above) room.high.y = strip.width - *rules.above;
  if (rules.from) room.low.x = std::max(room.low.x, *rules.from);
  if (rules.to) room.high.x = std::min(room.high.x, *rules.to);
  if (rules.on_fold) {
    room.low.y = 0;
    room.high.y = std::min(room.high.y, height);
  }
  return room;
}

std::optional<Rooms> rooms_of(const Marker& marker) {
  const auto ruled = [&marker](const Piece& piece) {
    return piece.rules.own_room() || (marker.shade && !piece.rules.shade.empty());
  };
  if (std::none_of(marker.pieces.begin(), marker.pieces.end(), ruled)) return std::nullopt;
  Rooms rooms;
  std::map<std::string_view, std::vector<std::uint32_t>> shades;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const Rules& rules = marker.pieces[i].rules;
    rooms.rules.push_back(rules);
    if (marker.shade && !rules.shade.empty()) shades[rules.shade].push_back(i);
  }
  for (auto& [name, pieces] : shades) {
    if (pieces.size() > 1) rooms.shades.push_back({std::move(pieces), *marker.shade});
  }
  return rooms;
}

std::optional<Error> refused_rule(const Marker& marker, const std::string& operation) {
  const auto named = [&](const Piece& piece, const std::string& list, std::size_t index) -> std::optional<Error> {
    const Rules& rules = piece.rules;
    std::string rule;
    if (rules.on_fold) {
      rule = "fold";
    } else if (rules.below || rules.above) {
      rule = rules.below ? "below" : "above";
    } else if (rules.from || rules.to) {
      rule = rules.from ? "from" : "to";
    } else if (marker.shade && !rules.shade.empty()) {
      rule = "shade";
    }
    if (rule.empty()) return std::nullopt;
    return Error{ErrorCode::kOutOfRange,
                 operation + " does not know the rule \"" + rule + "\" of piece \"" + piece.id +
                     "\"; only pieces without rules of their own are allowed",
                 "/" + list + "/" + std::to_string(index) + "/rules/" + rule};
  };
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (auto error = named(marker.pieces[i], "pieces", i)) return error;
  }
  for (std::size_t i = 0; i < marker.unplaced.size(); ++i) {
    if (auto error = named(marker.unplaced[i], "unplaced", i)) return error;
  }
  return std::nullopt;
}

}  // namespace selvage::marker
