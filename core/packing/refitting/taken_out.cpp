#include "core/packing/refitting/taken_out.h"

#include <string_view>
#include <unordered_map>

#include "core/model/ties.h"
#include "core/packing/bodies/on_cloth.h"

namespace selvage::packing::refitting {

TakenOut taken_out(const Marker& marker, std::span<const std::uint32_t> pieces) {
  std::vector<bool> taken(marker.pieces.size());
  for (const std::uint32_t piece : pieces) taken[piece] = true;
  TakenOut result{marker, {}};
  result.rest.pieces.clear();
  result.rest.unplaced.clear();
  for (std::size_t k = 0; k < taken.size(); ++k) {
    (taken[k] ? result.rest.unplaced : result.rest.pieces).push_back(marker.pieces[k]);
  }
  for (std::size_t k = 0; k < result.rest.unplaced.size(); ++k) {
    result.wanted.push_back(bodies::unplaced_piece(result.rest, k));
  }
  return result;
}

Marker put_back(const Marker& marker, const Marker& layout) {
  std::unordered_map<std::string_view, const Piece*> placed;
  for (const Piece& piece : layout.pieces) placed.emplace(piece.id, &piece);
  Marker result = marker;
  for (Piece& piece : result.pieces) {
    const Piece& found = *placed.at(piece.id);
    piece.at = found.at;
    piece.orientation = found.orientation;
  }
  return result;
}

std::vector<std::uint32_t> free_pieces(const Marker& marker) {
  const model::Ties ties = model::ties_of(marker);
  std::vector<std::uint32_t> free;
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    if (marker.pieces[k].group.empty() && ties.free(k)) free.push_back(k);
  }
  return free;
}

}  // namespace selvage::packing::refitting
