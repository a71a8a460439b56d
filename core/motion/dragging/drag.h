// Dragging: where a piece ends up when the user drags it to some position and, in push mode, where the other pieces
// move to make room.
//
// Placing: only the piece moves, with its group, to the free position nearest to the wanted one
// (core/motion/placing/place.h).  Pushing: it goes straight towards the wanted position, slides along the pieces in the
// way, and continues for a few rounds of the position model, in which nearby pieces move out of its way and no farther
// [Li94 4.2.2]; all others stay.
//
// Laws.  (1) No piece that moved overlaps another, comes too close to it or leaves the strip, proved in integers.
// (2) Locks and groups are respected.  (3) The same input gives the same answer, whatever the cache holds.
#pragma once

#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "core/motion/dragging/tuning.h"
#include "core/scene/laid_out.h"
#include "core/scene/run.h"

namespace selvage::motion::dragging {

enum class DragMode { kPlace, kPush };

struct Drag {
  Marker marker;
  bool pushed{};  // other pieces made room
};

// `to` is the wanted position of the piece's origin, which may be beyond the marker's present end, but not beyond the
// end of the cloth.  The piece stays where it is if no position is found.  REQUIRES: the piece is one of the marker's;
// `to` is on the lattice.
[[nodiscard]] Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, const scene::Run& run,
                        const DragTuning& tuning = {});
// The same for a marker that is laid out already.
[[nodiscard]] Drag drag(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, DragMode mode,
                        const scene::Run& run, const DragTuning& tuning = {});

}  // namespace selvage::motion::dragging
