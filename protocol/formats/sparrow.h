// The jagua-rs instance and sparrow solution JSON (github.com/JeroenGar/jagua-rs,
// github.com/JeroenGar/sparrow).
//
// The strip runs along x, strip_height is its width across; a placed item is turned by `rotation` about its
// shape's own origin, then translated.  Rotations are degrees; solutions written before jagua-rs switched to
// degrees are recognised by their allowed orientations and read as radians.  Shapes of type simple_polygon
// and polygon (holes treated as filled) are read.  An instance without a solution is refused: nothing is
// placed that a motion could start from.
//
// Fields the form does not define are kept and written back.  Of those Selvage reads: units, spacing (whole
// form); tilt_limit_deg (item); id, locked (placed item).
#pragma once

#include "core/base/result.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::formats {

[[nodiscard]] Result<MarkerFile> read_sparrow(const Json& document);
// Errors: kOrientationNotAllowed for a flipped piece.
[[nodiscard]] Result<Json> sparrow_document(const MarkerFile& file);

}  // namespace selvage::protocol::formats
