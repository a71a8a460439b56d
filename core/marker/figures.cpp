#include "core/marker/figures.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/marker/placed_pieces.h"
#include "core/marker/validity.h"

namespace selvage {

namespace {

// The pieces that are not as they were; nothing when more than pieces has changed.
std::optional<std::vector<bool>> changed_pieces(const Marker& before, const Marker& marker) {
  if (before.strip != marker.strip || before.spacing != marker.spacing || before.shapes != marker.shapes ||
      before.pieces.size() != marker.pieces.size()) {
    return std::nullopt;
  }
  std::vector<bool> changed;
  changed.reserve(marker.pieces.size());
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) changed.push_back(before.pieces[i] != marker.pieces[i]);
  return changed;
}

// Nothing is wrong about the pieces that have changed.
bool are_valid(const PlacedPieces& pieces, const Strip& strip, const std::vector<bool>& changed) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (changed[i] && protrusion_of(pieces.box(i), strip) > 0) return false;
  }
  const auto near = pairs_within(pieces, pieces.widest_spacing());
  return std::none_of(near.begin(), near.end(), [&](const PiecePair& pair) {
    return (changed[pair.first] || changed[pair.second]) && conflict(pieces, pair);
  });
}

}  // namespace

Figures figures_after(const Marker& before, const Marker& marker) {
  const auto changed = changed_pieces(before, marker);
  if (!changed) return figures_of(marker);
  const PlacedPieces pieces{marker};
  const Coord length = pieces.length();
  return {length, utilisation_at(marker, length), are_valid(pieces, marker.strip, *changed)};
}

Figures figures_of(const Marker& marker) {
  const PlacedPieces pieces{marker};
  const Coord length = pieces.length();
  return {length, utilisation_at(marker, length), is_valid(pieces, marker.strip)};
}

double utilisation_at(const Marker& marker, Coord length) {
  std::vector<Wide> copies(marker.shapes.size());
  for (const Piece& piece : marker.pieces) ++copies[piece.shape.value];
  Wide doubled = 0;
  for (std::size_t s = 0; s < copies.size(); ++s) {
    if (copies[s] > 0) doubled += copies[s] * doubled_area(marker.shapes[s].outline);
  }
  const double cloth = static_cast<double>(marker.strip.width) * static_cast<double>(length);
  return cloth > 0 ? static_cast<double>(doubled) / 2 / cloth : 0;
}

}  // namespace selvage
