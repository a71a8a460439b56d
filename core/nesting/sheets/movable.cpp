#include "core/nesting/sheets/movable.h"

namespace selvage::nesting::sheets {

std::optional<Error> unmovable(const std::vector<Piece>& pieces, const std::string& list) {
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece& piece = pieces[k];
    if (!piece.locked.x && !piece.locked.y && piece.group.empty()) continue;
    const bool grouped = !piece.group.empty();
    if (piece.rules.zone) {
      return Error{ErrorCode::kOutOfRange,
                   "\"" + piece.id + "\" is a zone of the marker's own cloth; give the zones of the sheets instead",
                   list + std::to_string(k) + "/rules/zone"};
    }
    return Error{ErrorCode::kOutOfRange,
                 "piece \"" + piece.id + "\" " + (grouped ? "belongs to a group" : "is locked in place") +
                     "; only pieces that may go to any place of any sheet are allowed",
                 list + std::to_string(k) + (grouped ? "/group" : "/locked")};
  }
  return std::nullopt;
}

}  // namespace selvage::nesting::sheets
