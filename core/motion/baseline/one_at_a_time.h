// One-piece-at-a-time compaction, the baseline that shows what moving all pieces at once gains.  Sweeps over the marker
// bump every piece to the left, in the order of their left ends, until nothing moves [Li94 1.2.2, 4.2.3].
#pragma once

#include "core/motion/compaction/compact.h"

namespace selvage::motion::baseline {

struct SweepSettings {
  int sweeps{200};          // at most this many
  double least_gain{1e-7};  // sweeps end with the first one in which all moves add up to less than this part of
                            // the width
  friend bool operator==(const SweepSettings&, const SweepSettings&) = default;
};

// Laws: those of compact().  The answer's rounds are sweeps; it solves no linear programs.  When cancelled, it stops
// between two bumps and returns the marker as it is then.
// Errors: those of repair_overlaps.
[[nodiscard]] Result<compaction::Compaction> compact_one_at_a_time(const Marker& start, const SweepSettings& settings,
                                                                   const scene::Run& run);

}  // namespace selvage::motion::baseline
