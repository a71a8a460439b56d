#include "protocol/methods/packing/search_params.h"

#include <algorithm>

#include "core/packing/bodies/bodies.h"
#include "core/packing/bodies/on_cloth.h"

namespace selvage::protocol::methods::packing {
namespace {

std::optional<PieceId> placed_or_unplaced(const Marker& marker, const std::string& id) {
  const auto same = [&id](const Piece& piece) { return piece.id == id; };
  const auto placed = std::ranges::find_if(marker.pieces, same);
  if (placed != marker.pieces.end()) return PieceId{static_cast<std::uint32_t>(placed - marker.pieces.begin())};
  const auto unplaced = std::ranges::find_if(marker.unplaced, same);
  if (unplaced == marker.unplaced.end()) return std::nullopt;
  return selvage::packing::bodies::unplaced_piece(marker, static_cast<std::size_t>(unplaced - marker.unplaced.begin()));
}

}  // namespace

selvage::packing::branching::WorkLimits limits_of(const SearchEffort& effort, const calls::CommonParams& call) {
  selvage::packing::branching::WorkLimits limits;
  if (effort.nodes || !call.deadline_ms) limits.nodes = effort.nodes.value_or(kStandardNodes);
  return limits;
}

Result<std::vector<PieceId>> chosen_pieces(const Marker& marker, const std::optional<std::vector<calls::Id>>& ids) {
  std::vector<PieceId> pieces;
  if (!ids) {
    for (std::size_t k = 0; k < marker.unplaced.size(); ++k) {
      pieces.push_back(selvage::packing::bodies::unplaced_piece(marker, k));
    }
    if (pieces.empty()) {
      return Error{ErrorCode::kOutOfRange,
                   "is absent, and the marker has no unplaced piece; the ids of the pieces to place are "
                   "allowed",
                   "/pieces"};
    }
    return pieces;
  }
  for (const calls::Id& id : *ids) {
    const auto piece = placed_or_unplaced(marker, id.text);
    if (!piece) {
      return Error{ErrorCode::kOutOfRange,
                   json::shortened(Json(id.text)) + " is not a piece of this marker; the id of one of its " +
                       std::to_string(marker.pieces.size()) + " placed and " + std::to_string(marker.unplaced.size()) +
                       " unplaced pieces is allowed",
                   "/pieces/" + std::to_string(pieces.size())};
    }
    pieces.push_back(*piece);
  }
  return pieces;
}

std::optional<Error> too_many(std::size_t pieces, std::string_view what, std::string_view field) {
  if (pieces <= selvage::packing::bodies::kMostBodies) return std::nullopt;
  return Error{ErrorCode::kTooManyPieces,
               std::to_string(pieces) + " " + std::string{what} + "; an exact search takes at most " +
                   std::to_string(selvage::packing::bodies::kMostBodies),
               std::string{field}};
}

}  // namespace selvage::protocol::methods::packing
