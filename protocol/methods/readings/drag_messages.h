// The words of the dragging hand: drag.begin, drag.move and drag.end.
#pragma once

#include <optional>
#include <string>

#include "core/motion/dragging/drag.h"
#include "protocol/calls/method.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::readings {

inline constexpr std::string_view kDragModeNames[] = {"place", "push"};  // by DragMode

// drag.begin {"markerId", "piece", "mode"?, "baseRev"?}
struct DragBegin {
  std::string marker_id, piece;
  motion::dragging::DragMode mode{};
  std::optional<Revision> base_revision;
};
[[nodiscard]] Result<DragBegin> decode_drag_begin(const Json& params);

// drag.move {"dragId", "to": [x, y]}
struct DragMove {
  std::string drag_id;
  formats::Decimal to;  // where the piece's origin is wanted
};
[[nodiscard]] Result<DragMove> decode_drag_move(const Json& params);

// drag.end {"dragId", "markerId", "commit"?, "opId"?}
struct DragEnd {
  std::string drag_id, marker_id;
  bool commit{true};
  std::optional<std::string> op_id;
};
[[nodiscard]] Result<DragEnd> decode_drag_end(const Json& params);

// The lattice point nearest to where the hand is.  Errors: kOutOfRange at /to when that is farther out than any
// coordinate of a marker may be.
[[nodiscard]] Result<Vec> within_reach(const formats::Decimal& to, const Marker& marker);
// {"at", "reached", "pushed", "placements": of all that moved, "length", "utilisation", "valid"}.  `to` is where the
// piece was wanted.  REQUIRES: `laid_out` is of `before`.
[[nodiscard]] Json drag_json(const Marker& before, const scene::LaidOut& laid_out, const motion::dragging::Drag& now,
                             PieceId piece, Vec to);

}  // namespace selvage::protocol::methods::readings
