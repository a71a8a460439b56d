#include "core/nesting/match_phases.h"

#include <map>
#include <string_view>

namespace selvage::nesting {

std::optional<Marker> with_sets_matched_to_cloth(const Marker& marker) {
  if (!marker.strip.repeat.any()) return std::nullopt;
  const auto in_set = [](const Piece& piece) { return piece.rules.match && !piece.rules.match_set.empty(); };
  std::map<std::string_view, Vec> phases;
  for (const bool locked : {true, false}) {
    for (const Piece& piece : marker.pieces) {
      const bool held = piece.locked.x || piece.locked.y || !piece.group.empty();
      if (in_set(piece) && held == locked) phases.try_emplace(piece.rules.match_set, piece.at + turned_match(piece));
    }
  }
  Marker matched = marker;
  bool any = false;
  for (auto* pieces : {&matched.pieces, &matched.unplaced}) {
    for (Piece& piece : *pieces) {
      if (!in_set(piece)) continue;
      const auto phase = phases.find(piece.rules.match_set);
      if (phase != phases.end()) piece.rules.phase = phase->second;
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
    for (Piece& piece : *pieces) piece.rules = *rules.at(piece.id);
  }
}

}  // namespace selvage::nesting
