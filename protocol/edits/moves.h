// Moves: the difference between two states of a marker with the same pieces and shapes on the same strip, of which only
// placements and locks differ.  Moves are far smaller than the marker, so undo, the journal and notifications use
// moves, and the whole marker only if more than that changed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::edits {

struct Move {
  std::uint32_t index{};  // of the piece
  Piece piece;            // as it is afterwards
};
using Moves = std::vector<Move>;  // by index

// Returns nothing if the states differ in more than moves.  Law: moved(before, *moves_between(before, after)) has the
// marker and attributes of `after`.
[[nodiscard]] std::optional<Moves> moves_between(const MarkerFile& before, const MarkerFile& after);
// REQUIRES: every index is one of a piece of the file.
[[nodiscard]] MarkerFile moved(MarkerFile file, const Moves& moves);

// [[index, piece in the native form], ...], exact.
[[nodiscard]] Json moves_json(const Marker& marker, const Moves& moves);
// Errors: 10xx and 12xx for anything that moves_json cannot have written for a state of this marker.
[[nodiscard]] Result<Moves> read_moves(const Json& list, const Marker& marker);

}  // namespace selvage::protocol::edits
