// The drawing of a marker after a command, with the requested overlays.
#pragma once

#include "protocol/drawing/svg.h"

namespace selvage::cli::commands {

struct Overlays {
  bool arrows{};         // displacements of the pieces, and the forces on them
  bool critical_path{};  // the contacts that determine the length
};

// REQUIRES: `end` is the result of a call with these parameters on `start`.  A marker that is not valid has no critical
// path.
[[nodiscard]] protocol::drawing::SvgOptions result_drawing(const MarkerFile& end, const Marker& start,
                                                           const Json& params, const Overlays& overlays);

}  // namespace selvage::cli::commands
