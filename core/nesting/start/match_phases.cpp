#include "core/nesting/start/match_phases.h"

#include <map>
#include <string_view>

namespace selvage::nesting::start {
namespace {

using Phases = std::map<std::string_view, Vec>;

bool in_set(const Piece& piece) {
  return piece.rules.match && !piece.rules.match_set.empty();
}

// Adds the phases of the sets of which no piece is placed: where the match point of the piece with the least room
// across lies when the piece, as it is turned, is in the lower left corner of its room.
void add_unplaced(const Marker& marker, Phases& phases) {
  const Phases of_placed = phases;
  std::map<std::string_view, Coord> least;
  for (const Piece& piece : marker.unplaced) {
    if (!in_set(piece) || of_placed.contains(piece.rules.match_set)) continue;
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
    const Box box = box_of(outline);
    const marker::FoldEdge fold = fold_edge(piece.rules, outline, marker.strip);
    const Box room = room_for(piece.rules, box.height(), fold, marker.strip, kLatticeLimit);
    const Coord spare = room.height() - box.height();
    const auto [found, first] = least.try_emplace(piece.rules.match_set, spare);
    if (!first && found->second <= spare) continue;
    found->second = spare;
    phases[piece.rules.match_set] = room.low - box.low + turned_match(piece);
  }
}

}  // namespace

std::optional<Marker> with_sets_matched_to_cloth(const Marker& marker) {
  if (!marker.strip.repeat.any()) return std::nullopt;
  Phases phases;
  for (const bool locked : {true, false}) {
    for (const Piece& piece : marker.pieces) {
      const bool held = piece.locked.x || piece.locked.y || !piece.group.empty();
      if (in_set(piece) && held == locked) phases.try_emplace(piece.rules.match_set, piece.at + turned_match(piece));
    }
  }
  add_unplaced(marker, phases);
  Marker matched = marker;
  bool any = false;
  for (auto* pieces : {&matched.pieces, &matched.unplaced}) {
    for (Piece& piece : *pieces) {
      if (!in_set(piece)) continue;
      piece.rules.phase = phases.at(piece.rules.match_set);
      piece.rules.match_set.clear();
      any = true;
    }
  }
  return any ? std::optional{std::move(matched)} : std::nullopt;
}

void give_back_rules(Marker& marker, const Marker& original) {
  std::map<std::string_view, const marker::Rules*> rules;
  for (const auto* pieces : {&original.pieces, &original.unplaced}) {
    for (const Piece& piece : *pieces) rules.emplace(piece.id, &piece.rules);
  }
  for (auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (Piece& piece : *pieces) {
      if (const auto found = rules.find(piece.id); found != rules.end()) piece.rules = *found->second;
    }
  }
}

}  // namespace selvage::nesting::start
