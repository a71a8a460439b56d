// Opening a gap: the pieces around an unoccupied region move away from it, so that another piece may find room there,
// at fixed length of the marker [Li94 4.2.2].
//
// Method.  Vector compaction, one round at a time.  The forces are chosen anew before each round: away from a point, as
// in the thesis, or along the outward normals of the region's outline, the directions in which its area grows fastest.
// A gap may grow by joining the next one: its area is that of the whole region.
// Laws.  (1) The answer is valid, proved in integers, and never longer.  (2) The gap is never smaller than before: a
// round that makes it smaller is discarded.  (3) Locked pieces stay in place to the lattice unit.  (4) The same input
// gives the same answer, whatever the cache holds.
#pragma once

#include <cstddef>
#include <variant>

#include "core/marker/unoccupied.h"
#include "core/motion/compaction/compact.h"

namespace selvage::motion::compaction {

// What the pieces move away from.
struct AwayFromPoint {
  Vec point;  // in an unoccupied region
};
struct AwayFromOutline {
  std::size_t region{};  // index into the unoccupied_regions of the input
};
using GapChoice = std::variant<AwayFromPoint, AwayFromOutline>;

// The marker never becomes longer.
struct OpenedGap : repair::MotionResult {
  Vec inside;                              // a point of the gap, before and after
  marker::UnoccupiedRegion before, after;  // the region that holds that point
};

// Settings as for compaction (gravity is not used; least_gain is relative to the area of the gap); `regions` defines
// what counts as a region.
// Errors: those of repair_overlaps; kStoppedEarly when cancelled before the gap was found; kOutOfRange for a point in
// no unoccupied region, for a region that does not exist, and for one that the repair closed.
[[nodiscard]] Result<OpenedGap> open_gap(const Marker& start, const GapChoice& choice,
                                         const CompactionSettings& settings, const marker::UnoccupiedSettings& regions,
                                         const scene::Run& run, const GapTuning& tuning = {});

}  // namespace selvage::motion::compaction
