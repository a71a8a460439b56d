// The dragging hand: where a piece comes to lie that a hand wants at some place, and, when the others are to make way,
// where they flow to.
//
// Placing: only the piece moves, with its group, to the free position nearest to the wanted one
// (core/motion/place.h).  Pushing: it goes straight towards the wanted place, along what is in the way, and on from
// there in a few rounds of the position model, in which
// the pieces in reach move out of its way and no farther [Li94 4.2.2]; all others stay.
//
// Laws.  (1) No piece that moved overlaps any other, comes too close to it or leaves the strip, proved in integers.
// (2) Locks and groups hold.  (3) Same input, same answer, whatever the cache holds.
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
  bool pushed{};  // the others made way
};

// `to` is where the piece's origin is wanted, which may be beyond the marker's present end, but not the cloth's.  A
// piece for which nothing is found stays.  REQUIRES: the piece is one of the marker's; `to` is on the lattice.
[[nodiscard]] Drag drag(const Marker& start, PieceId piece, Vec to, DragMode mode, const scene::Run& run,
                        const DragTuning& tuning = {});
// The same, of a marker that is laid out already.
[[nodiscard]] Drag drag(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, Vec to, DragMode mode,
                        const scene::Run& run, const DragTuning& tuning = {});

}  // namespace selvage::motion::dragging
