#include "core/nesting/start/fixed_pieces.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/marker/clearance.h"
#include "core/marker/placed_pieces.h"

namespace selvage::nesting::start {

Marker with_pieces_taken_off(const Marker& given, const layout::PieceSet& set) {
  Marker bare = given;
  bare.pieces.clear();
  bare.unplaced.clear();
  for (std::size_t i = 0; i < given.pieces.size(); ++i) {
    Piece piece = given.pieces[i];
    if (!set.fixed[i]) piece.at = {};
    (set.fixed[i] ? bare.pieces : bare.unplaced).push_back(std::move(piece));
  }
  bare.unplaced.insert(bare.unplaced.end(), given.unplaced.begin(), given.unplaced.end());
  return bare;
}

std::optional<Error> defect_of_fixed(const Marker& start, const std::vector<bool>& fixed) {
  const marker::PlacedPieces pieces{start};
  for (std::uint32_t i = 0; i < start.pieces.size(); ++i) {
    if (!fixed[i]) continue;
    if (marker::protrusion_of(pieces, i, start.strip) > 0) {
      return Error{ErrorCode::kOutsideStrip,
                   "piece \"" + start.pieces[i].id +
                       "\" must stay where it is, but lies outside the strip or the room that its rules leave",
                   "/pieces/" + std::to_string(i)};
    }
  }
  for (const marker::Shade& shade : pieces.shades()) {
    std::optional<Box> box;
    for (const std::uint32_t i : shade.pieces) {
      if (fixed[i]) box = box ? united(*box, pieces.box(i)) : pieces.box(i);
    }
    if (!box || box->width() <= shade.length) continue;
    return Error{ErrorCode::kOutsideStrip,
                 "pieces of shade \"" + start.pieces[shade.pieces.front()].rules.shade +
                     "\" must stay where they are, but lie too far from each other",
                 "/shade"};
  }
  for (const marker::MatchSet& set : pieces.match_sets()) {
    const auto first = std::ranges::find_if(set, [&](const std::uint32_t i) { return fixed[i]; });
    for (auto other = first; other != set.end(); ++other) {
      if (!fixed[*other] || pieces.off_phase(*other, *first) == Vec{}) continue;
      return Error{ErrorCode::kOutsideStrip,
                   "pieces \"" + start.pieces[*first].id + "\" and \"" + start.pieces[*other].id +
                       "\" of one match set must stay where they are, but are off each other's repeats",
                   "/pieces/" + std::to_string(*other)};
    }
  }
  for (const auto& [first, second] : conflicts(pieces)) {
    if (!fixed[first] || !fixed[second]) continue;
    return Error{ErrorCode::kMarkerOverlaps,
                 "pieces \"" + start.pieces[first].id + "\" and \"" + start.pieces[second].id +
                     "\" must stay where they are, but overlap or are too close",
                 "/pieces/" + std::to_string(second)};
  }
  return std::nullopt;
}

std::vector<bool> kept_where_valid(const Marker& start, const layout::PieceSet& set) {
  if (all_clear(marker::PlacedPieces{start}, start.strip)) return std::vector<bool>(start.pieces.size(), true);
  return {set.fixed.begin(), set.fixed.begin() + static_cast<std::ptrdiff_t>(start.pieces.size())};
}

}  // namespace selvage::nesting::start
