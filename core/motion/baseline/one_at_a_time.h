// One piece at a time: what can be had without moving pieces together.  Sweeps over the marker bump every piece to the
// left in the order of their left ends, until nothing moves [Li94 1.2.2, 4.2.3].  The baseline that shows what moving
// all pieces at once is worth.
#pragma once

#include "core/motion/compaction/compact.h"

namespace selvage::motion::baseline {

struct SweepSettings {
  int sweeps{200};          // at most this many
  double least_gain{1e-7};  // the last sweep is the one whose pieces move, all together, by less than this part of the
                            // width
  friend bool operator==(const SweepSettings&, const SweepSettings&) = default;
};

// Laws: those of compact().  The answer's rounds are sweeps; it takes no linear programs.  Asked to stop, it does so
// between two bumps and hands back the marker as it is then.
// Errors: those of heal.
[[nodiscard]] Result<compaction::Compaction> compact_one_at_a_time(const Marker& start, const SweepSettings& settings,
                                                                   const scene::Run& run);

}  // namespace selvage::motion::baseline
