// Opening a gap: the pieces around an unoccupied region move away from it, so that another piece may find room there;
// the marker's length is held [Li94 4.2.2].
//
// Method.  Vector compaction, one round at a time.  The forces are drawn anew before each round: away from a point, as
// the thesis draws them, or along the outward normals of the region's outline, which is how its area grows fastest.
// A gap may grow by opening the way into the next one: its area is that of the whole region.
// Laws.  (1) The answer is valid, proved in integers, and never longer.  (2) The gap is never smaller than before: a
// round that made it so is not taken.  (3) Locked pieces stay to the lattice unit.  (4) Same input, same answer,
// whatever the cache holds.
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
  std::size_t region{};  // its place in the list of unoccupied_regions, of the marker as it comes
};
using GapChoice = std::variant<AwayFromPoint, AwayFromOutline>;

// The marker never becomes longer.
struct OpenedGap : repair::MotionResult {
  Vec inside;                              // a point of the gap, before and after
  marker::UnoccupiedRegion before, after;  // the region that holds that point
};

// Settings as for compaction (gravity is not used; least_gain is the part by which the last round enlarges the gap);
// `regions` says what is a region.
// Errors: those of heal; kStoppedEarly when asked to stop before the gap was found; kOutOfRange for a point in no
// unoccupied region, or a region that is not there, or that healing closed.
[[nodiscard]] Result<OpenedGap> open_gap(const Marker& start, const GapChoice& choice,
                                         const CompactionSettings& settings, const marker::UnoccupiedSettings& regions,
                                         const scene::Run& run, const GapTuning& tuning = {});

}  // namespace selvage::motion::compaction
