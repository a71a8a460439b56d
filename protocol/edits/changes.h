// Calls that change a marker by hand: apply, undo, redo; and what is told of any change, to its author and to those who
// watch the marker.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/calls/messages.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {

// What every such call takes: {"markerId", "baseRev"?, "opId"?}
struct ChangeCall {
  std::string marker_id;
  std::optional<Revision> base_revision;  // refuse when the marker is at another
  std::optional<std::string> op_id;       // the client's name for the call: a retry of it gets the same answer
};

// marker.apply {"ops": [...]}
struct MarkerApply {
  ChangeCall call;
  std::vector<Edit> edits;
};
[[nodiscard]] Result<MarkerApply> decode_marker_apply(const Json& params);

// marker.undo, marker.redo
[[nodiscard]] Result<ChangeCall> decode_change(const Json& params);

// The file with its marker's next state, which may have lost pieces: each that stays keeps its attributes.
[[nodiscard]] MarkerFile with_marker(const MarkerFile& file, Marker next);

// {"id", "shape", "at", "rotation", "flip", "tilt", "locked", "group"?, "buffer"?}
[[nodiscard]] Json placement_json(const Marker& marker, const Piece& piece);
// {"name", "pieces", "length", "utilisation", "valid"}
[[nodiscard]] Json figures_json(const Marker& marker);
// {"placements": of pieces that are new or lie or are locked otherwise, "removed": [ids], "whole": true when more than
// that changed, figures...}
[[nodiscard]] Json change_json(const MarkerFile& before, const MarkerFile& after);

}  // namespace selvage::protocol::edits
