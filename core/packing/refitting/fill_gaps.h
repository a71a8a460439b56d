// Filling gaps: small pieces are taken out of a marker, the others are compacted, and the small ones are put back where
// there is room, which may be anywhere; then the marker is compacted [Li94 4.2.2 does this by hand].
//
// First the marker is compacted, and unplaced pieces go to gaps, the largest first.  Then come trials: each draws a few
// small pieces that lie near each other, mostly one of the critical path, and puts them back one after another at
// random places where they fit or, where that fails, all at once (contain.h).
//
// Laws.  (1) The answer is valid, proved in integers, and never longer than that of standard compaction.  (2) Locked
// pieces and groups are not taken out; compaction moves groups as one.  (3) Unplaced pieces are placed only within the
// length that the marker has when it is compacted.  (4) The same input and settings give the same answer, whatever the
// cache holds and however many threads are used.  (5) When cancelled, it returns the best marker so far.
#pragma once

#include <cstdint>

#include "core/base/result.h"
#include "core/motion/repair/motion_result.h"
#include "core/packing/branching/search.h"
#include "core/packing/refitting/tuning.h"

namespace selvage::packing::refitting {

struct GapSettings {
  std::uint64_t trials{200};
  std::size_t pieces{2};     // taken out in a trial at most
  std::uint64_t nodes{100};  // of every search for room
  std::uint64_t seed{1};
  bool turns{true};  // refitted pieces may take other orientations that their shapes allow
  GapTuning tuning{};
  friend bool operator==(const GapSettings&, const GapSettings&) = default;
};

// A round is a trial.
struct GapFilling : motion::repair::MotionResult {
  std::size_t placed{};  // pieces that were unplaced
  std::uint64_t kept{};  // trials that made the marker shorter
  branching::Work work;  // of all searches for room
};

// Errors: those of compaction.
[[nodiscard]] Result<GapFilling> fill_gaps(const Marker& start, const GapSettings& settings, const scene::Run& run);

}  // namespace selvage::packing::refitting
