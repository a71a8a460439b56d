// The jagua-rs instance and sparrow solution JSON (github.com/JeroenGar/jagua-rs,
// github.com/JeroenGar/sparrow).
//
// The strip runs along x, and strip_height is its width across.  A placed item is rotated by `rotation` about the
// origin of its shape, then translated.  Rotations are degrees; solutions written before jagua-rs switched to degrees
// are recognised by their allowed orientations and read as radians.  Shapes of type simple_polygon and polygon (holes
// treated as filled) are read.
//
// Instances of bins (jagua/bins.h), which have no strip_height, are read as if the strip were as wide as the widest
// bin.  An item's min_quality becomes the worst class of cloth that its pieces accept.
//
// Copies that an item's demand asks for and the solution does not place, which are all of them in an instance without a
// solution, are the marker's unplaced pieces; their ids are the least numbers that no piece has.  They are written as
// the part of the demand that is not placed; nothing else is kept of them.
//
// Fields that the format does not define are kept and written back, but for nulls, which count as absent.  Of these,
// Selvage reads: units, resolution, spacing, longest and others of the strip (whole form); tilt_limit_deg (item); id,
// locked, tilt_deg (placed item).  The resolution is written where the numbers alone would lead to another, on which
// the corners of turned pieces would be rounded to other places.
#pragma once

#include "core/base/result.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::formats {

[[nodiscard]] Result<MarkerFile> read_sparrow(const Json& document);
// Errors: kOrientationNotAllowed for a flipped piece.
[[nodiscard]] Result<Json> sparrow_document(const MarkerFile& file);

}  // namespace selvage::protocol::formats
