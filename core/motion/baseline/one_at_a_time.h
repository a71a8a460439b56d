// One-piece-at-a-time compaction, the baseline that shows what moving all pieces at once gains: sweeps of single-piece
// moves (core/motion/piece/sweep.h) and nothing else [Li94 1.2.2, 4.2.3].
#pragma once

#include "core/motion/compaction/compact.h"
#include "core/motion/piece/sweep.h"

namespace selvage::motion::baseline {

using piece::SweepSettings;

// Laws: those of compact().  The answer's rounds are sweeps; it solves no linear programs.  When cancelled, it stops
// between two bumps and returns the marker as it is then.
// Errors: those of repair_overlaps.
[[nodiscard]] Result<compaction::Compaction> compact_one_at_a_time(const Marker& start, const SweepSettings& settings,
                                                                   const scene::Run& run);

}  // namespace selvage::motion::baseline
