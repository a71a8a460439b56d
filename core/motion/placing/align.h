// Alignment: chosen pieces move along one axis until the same side of each lies on one line, the line of the piece that
// is already outermost on that side.
//
// Laws.  (1) The marker is valid and no longer than before, and only chosen pieces, with their groups, have moved,
// along one axis.  (2) A piece whose aligned position is free is aligned.  A piece that others keep from it goes to the
// nearest free position on its way along the axis, when that is nearer than where it was.  (3) Aligning again changes
// nothing that is aligned.
#pragma once

#include <span>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/motion/placing/tuning.h"
#include "core/motion/repair/motion_result.h"
#include "core/scene/strip_edge.h"

namespace selvage::motion::placing {

struct Alignment : repair::MotionResult {
  Coord line{};           // x for the left and right side, y for the lower and upper one; lattice units
  std::size_t aligned{};  // chosen pieces whose side lies on the line
};

// Aligns the pieces' sides that face `side` of the strip.  Pieces that are locked on the axis stay where they are, and
// the line is theirs when they are outermost. REQUIRES: the pieces are the marker's. Errors: kOutOfRange when fewer
// than two pieces are chosen; those of repair_overlaps.
[[nodiscard]] Result<Alignment> align(const Marker& start, std::span<const PieceId> pieces, StripEdge side,
                                      const scene::Run& run);

}  // namespace selvage::motion::placing
