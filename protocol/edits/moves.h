// Moves: what differs between two states of one marker when it is the same pieces, of the same shapes, on the same
// strip, that lie or are locked otherwise.  Far smaller than the marker: undo, the journal and whoever watches a marker
// all keep or send moves, and the whole only when more than that changed.
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

// Nothing when more than moves leads from one to the other.  Law: moved(before, *moves_between(before, after)) has the
// marker and attributes of `after`.
[[nodiscard]] std::optional<Moves> moves_between(const MarkerFile& before, const MarkerFile& after);
// REQUIRES: every index is one of a piece of the file.
[[nodiscard]] MarkerFile moved(MarkerFile file, const Moves& moves);

// [[index, piece in the native form], ...], exact.
[[nodiscard]] Json moves_json(const Marker& marker, const Moves& moves);
// Errors: 10xx and 12xx for anything that moves_json would not have written of a state of this marker.
[[nodiscard]] Result<Moves> read_moves(const Json& list, const Marker& marker);

}  // namespace selvage::protocol::edits
