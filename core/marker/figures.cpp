#include "core/marker/figures.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"

namespace selvage::marker {
namespace {

// The pieces that differ between the two markers; nothing when the markers differ in more than their pieces.
std::optional<std::vector<std::uint32_t>> changed_pieces(const Marker& before, const Marker& marker) {
  if (before.strip != marker.strip || before.spacing != marker.spacing || before.overlap != marker.overlap ||
      before.shade != marker.shade || before.shapes != marker.shapes || before.pieces.size() != marker.pieces.size()) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> changed;
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (before.pieces[i] != marker.pieces[i]) changed.push_back(i);
  }
  return changed;
}

// The layout `pieces` with the changed pieces at their new positions.  Nothing when a changed piece has another shape,
// orientation, buffer or overlap allowance, or other rules, so that the layout cannot be reused.
std::optional<PlacedPieces> moved(const Marker& before, const PlacedPieces& pieces, const Marker& marker,
                                  std::span<const std::uint32_t> changed) {
  std::vector<Vec> positions = pieces.positions();
  for (const std::uint32_t i : changed) {
    const Piece& was = before.pieces[i];
    const Piece& is = marker.pieces[i];
    if (was.shape != is.shape || was.orientation != is.orientation || was.buffer != is.buffer ||
        was.overlap != is.overlap || was.rules != is.rules) {
      return std::nullopt;
    }
    positions[i] = is.at;
  }
  PlacedPieces now = pieces;
  now.place(std::move(positions));
  return now;
}

Wide doubled_area_of(const Marker& marker) {
  std::vector<Wide> copies(marker.shapes.size());
  for (const Piece& piece : marker.pieces) copies[piece.shape.value] += piece.rules.zone ? 0 : 1;
  Wide doubled = 0;
  for (std::size_t s = 0; s < copies.size(); ++s) {
    if (copies[s] > 0) doubled += copies[s] * doubled_area(marker.shapes[s].outline);
  }
  return doubled;
}

double utilisation_of(Wide doubled_area, const Strip& strip, Coord length) {
  const double cloth = static_cast<double>(strip.width) * static_cast<double>(length);
  return cloth > 0 ? static_cast<double>(doubled_area) / 2 / cloth : 0;
}

}  // namespace

Figures figures_after(const Marker& before, const PlacedPieces& pieces, const Figures& figures, const Marker& marker) {
  const auto changed = changed_pieces(before, marker);
  if (!changed) return figures_of(marker);
  auto now = moved(before, pieces, marker, *changed);
  const Wide area = now ? figures.doubled_area : doubled_area_of(marker);
  if (!now) now.emplace(marker);
  const Coord length = now->length();
  const bool within = std::none_of(changed->begin(), changed->end(),
                                   [&](std::uint32_t i) { return protrusion_of(*now, i, marker.strip) > 0; });
  return {length, utilisation_of(area, marker.strip, length),
          within && keep_joint_rules(*now) && are_clear(*now, *changed), area};
}

Figures figures_of(const Marker& marker) {
  return figures_of(marker, PlacedPieces{marker});
}

Figures figures_of(const Marker& marker, const PlacedPieces& pieces) {
  const Coord length = pieces.length();
  const Wide area = doubled_area_of(marker);
  return {length, utilisation_of(area, marker.strip, length), all_clear(pieces, marker.strip), area};
}

double utilisation_at(const Marker& marker, Coord length) {
  return utilisation_of(doubled_area_of(marker), marker.strip, length);
}

}  // namespace selvage::marker
